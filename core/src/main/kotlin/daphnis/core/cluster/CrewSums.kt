package daphnis.core.cluster

import daphnis.core.CommonNumber
import daphnis.core.RemoteParts
import daphnis.core.force.EnergySums
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.CentralMoments
import daphnis.core.population.FirstMoments
import daphnis.core.population.MaterialSums
import daphnis.core.population.Means
import daphnis.core.population.Population
import daphnis.core.population.PopulationFold
import daphnis.core.population.SpinSums
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.carriesHeat
import java.nio.ByteBuffer

/**
 * The sums over the spheres that the nodes of a crew hold. In each of two rounds the leader asks all nodes, each sums
 * over its spheres ([NodeSums]), and the leader merges what they answer. Sums are exact, so the result has the bits of
 * a sum over all spheres in one place.
 */
internal class CrewSums(setup: ScenarioSetup) : RemoteParts {
    override val energies = EnergySums(setup.forces, setup.boundary)
    override val spins = SpinSums(setup.momentFactor, setup.boundary.space)
    override val materials = setup.boundary.let {
        MaterialSums(setup.population.materials, it.meanFlow, setup.scenario.firstBody, it.space)
    }

    // Of one node.
    private val firstOfNode = FirstMoments(setup.boundary.meanFlow?.normalAxis ?: 0, setup.scenario.firstBody)
    private val centralOfNode = CentralMoments(setup.boundary.meanFlow, setup.scenario.firstBody, setup.carriesHeat)
    private val energiesOfNode = EnergySums(setup.forces, setup.boundary)
    private val spinsOfNode = SpinSums(setup.momentFactor, setup.boundary.space)
    private val materialsOfNode = MaterialSums(setup.population.materials)
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
        spins.parts.clear()
        crew!!.ask(Command.FIRST_SUMS, {}) { answer ->
            firstOfNode.read(answer)
            sums.merge(firstOfNode)
            energiesOfNode.read(answer)
            energies.merge(energiesOfNode)
            spinsOfNode.parts.read(answer)
            spins.parts.merge(spinsOfNode.parts)
        }
    }

    override fun central(means: Means, sums: CentralMoments) {
        sums.clear(means)
        materials.parts.clear()
        val count = materials.materials.size
        crew!!.ask(Command.CENTRAL_SUMS, { it.put(Means.BYTES, means::write).int(count) }) { answer ->
            centralOfNode.read(means, answer)
            sums.merge(centralOfNode)
            materialsOfNode.parts.read(answer)
            materials.parts.merge(materialsOfNode.parts)
        }
    }

    override fun number(which: CommonNumber, force: Int): Double {
        val answers = ArrayList<Double>()
        crew!!.ask(Command.NUMBER, { it.byte(which.ordinal).int(force) }) { answers += it.double }
        check(answers.all { it.toRawBits() == answers[0].toRawBits() }) { "nodes have found $which to be $answers" }
        return answers[0]
    }
}

/** The sums over the spheres of one node, on the threads of its [loop]. */
internal class NodeSums(
    private val setup: ScenarioSetup,
    private val population: Population,
    private val loop: RangeLoop,
) {
    private val fold = PopulationFold(setup.boundary.meanFlow, setup.scenario.firstBody, setup.carriesHeat)
    private val first = FirstMoments(setup.boundary.meanFlow?.normalAxis ?: 0, setup.scenario.firstBody)
    private val central = CentralMoments(setup.boundary.meanFlow, setup.scenario.firstBody, setup.carriesHeat)
    private val energies = EnergySums(setup.forces, setup.boundary)
    private val spins = SpinSums(setup.momentFactor, setup.boundary.space)
    private var materials = byMaterial(0)
    private val means = Means()

    /** Nodes know materials by number. */
    private fun byMaterial(count: Int) =
        MaterialSums(List(count) { "" }, setup.boundary.meanFlow, setup.scenario.firstBody)

    /** The answer to [Command.FIRST_SUMS] for the state at [time]. */
    fun first(time: Double): ByteBuffer {
        fold.over(population, loop) { fold.first(first) }
        energies.take(population, time, loop)
        spins.take(population, loop)
        return MessageWriter().put(FirstMoments.MOST_BYTES, first::write).put(energies.mostBytes, energies::write)
            .put(spins.parts.mostBytes, spins.parts::write).message()
    }

    /** The answer to [Command.CENTRAL_SUMS] with the means and the number of materials in [question]. */
    fun central(question: ByteBuffer): ByteBuffer {
        means.read(question)
        val count = question.getInt()
        if (count != materials.materials.size) materials = byMaterial(count)
        fold.over(population, loop) { fold.central(means, central) }
        materials.take(population, means, loop)
        return MessageWriter().put(CentralMoments.MOST_BYTES, central::write)
            .put(materials.parts.mostBytes, materials.parts::write).message()
    }
}
