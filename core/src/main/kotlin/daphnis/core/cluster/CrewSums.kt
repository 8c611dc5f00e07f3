package daphnis.core.cluster

import daphnis.core.RemoteParts
import daphnis.core.force.EnergySums
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.CentralMoments
import daphnis.core.population.FirstMoments
import daphnis.core.population.Means
import daphnis.core.population.Population
import daphnis.core.population.PopulationFold
import daphnis.core.scenario.ScenarioSetup
import java.nio.ByteBuffer

/**
 * The sums over the spheres that the nodes of a crew hold. In each of two rounds the leader asks all nodes, each sums
 * over its spheres ([NodeSums]), and the leader merges what they answer. Sums are exact, so the result has the bits of
 * a sum over all spheres in one place.
 */
internal class CrewSums(setup: ScenarioSetup) : RemoteParts {
    override val energies = EnergySums(setup.forces, setup.boundary)

    // Of one node.
    private val firstOfNode = FirstMoments(setup.boundary.meanFlow?.normalAxis ?: 0, setup.scenario.firstBody)
    private val centralOfNode = CentralMoments(setup.boundary.meanFlow, setup.scenario.firstBody)
    private val energiesOfNode = EnergySums(setup.forces, setup.boundary)
    private var crew: Crew? = null

    /** Does [act], in which the rounds are with [crew]. */
    inline fun with(crew: Crew, act: (RemoteParts) -> Unit) {
        this.crew = crew
        try {
            act(this)
        } finally {
            this.crew = null
        }
    }

    override fun first(sums: FirstMoments) {
        sums.clear()
        energies.clear()
        crew!!.ask(Command.FIRST_SUMS, {}) { answer ->
            firstOfNode.read(answer)
            sums.merge(firstOfNode)
            energiesOfNode.read(answer)
            energies.merge(energiesOfNode)
        }
    }

    override fun central(means: Means, sums: CentralMoments) {
        sums.clear(means)
        crew!!.ask(Command.CENTRAL_SUMS, { it.put(Means.BYTES, means::write) }) { answer ->
            centralOfNode.read(means, answer)
            sums.merge(centralOfNode)
        }
    }
}

/** The sums over the spheres of one node, on the threads of its [loop]. */
internal class NodeSums(setup: ScenarioSetup, private val population: Population, private val loop: RangeLoop) {
    private val fold = PopulationFold(setup.boundary.meanFlow, setup.scenario.firstBody)
    private val first = FirstMoments(setup.boundary.meanFlow?.normalAxis ?: 0, setup.scenario.firstBody)
    private val central = CentralMoments(setup.boundary.meanFlow, setup.scenario.firstBody)
    private val energies = EnergySums(setup.forces, setup.boundary)
    private val means = Means()

    /** The answer to [Command.FIRST_SUMS] for the state at [time]. */
    fun first(time: Double): ByteBuffer {
        fold.over(population, loop) { fold.first(first) }
        energies.take(population, time, loop)
        return MessageWriter().put(FirstMoments.MOST_BYTES, first::write).put(energies.mostBytes, energies::write)
            .message()
    }

    /** The answer to [Command.CENTRAL_SUMS] with the means in [question]. */
    fun central(question: ByteBuffer): ByteBuffer {
        means.read(question)
        fold.over(population, loop) { fold.central(means, central) }
        return MessageWriter().put(CentralMoments.MOST_BYTES, central::write).message()
    }
}
