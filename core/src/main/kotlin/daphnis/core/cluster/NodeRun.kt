@file:JvmName("NodeWorks")

package daphnis.core.cluster

import daphnis.core.CarriedState
import daphnis.core.CommonNumber
import daphnis.core.FreePathTimeStep
import daphnis.core.Output
import daphnis.core.PerSphereTimeStep
import daphnis.core.Simulation
import daphnis.core.StoppingTimeStep
import daphnis.core.Stops
import daphnis.core.TimeStep
import daphnis.core.collision.CollisionCounters
import daphnis.core.engine.StepTally
import daphnis.core.measure
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.IdPlaces
import daphnis.core.population.Partitioned
import daphnis.core.population.Population
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import java.nio.ByteBuffer

/** What a node does for the runs of scenarios: it advances its part of the spheres as the leader of its crew asks. */
@JvmName("ofRuns")
public fun nodeWork(): NodeWork = NodeWork { mail, threads -> NodeRun(mail, threads).run() }

/** The part of one node in one crew. */
internal class NodeRun(private val mail: Mail, private val threads: Int) {
    private val turns = Turns(mail)
    private lateinit var engine: NodeEngine
    private lateinit var simulation: Simulation
    private lateinit var population: Population
    private lateinit var carried: CarriedState
    private var sendsRecords = false
    private var tally: StepTally? = null
    private val counters get() = simulation.collisions!!.counters

    /** Serves until the mail closes. */
    fun run() {
        val begin = Begin.read(mail.receive(Mail.LEADER))
        population = receivePart(begin)
        val setup = ScenarioSetup.of(ScenarioJson.parse(begin.scenario, SOURCE), SOURCE, population)
        carried = setup.carried
        carried.numbers = begin.carried
        for (part in (setup.forces + setup.boundary).filterIsInstance<Partitioned>()) {
            part.partition = NodePartition(turns)
        }
        NodeEngine(turns, begin.threads, FixedPool(threads)).use {
            engine = it
            simulation = simulationOf(setup, begin)
            simulation.use { serve(NodeSums(setup, population, engine.loop)) }
        }
    }

    private fun receivePart(begin: Begin): Population {
        val part = Population(SpheresWire.receive(mail, Mail.LEADER), emptyList())
        part.beginPart(IdPlaces.like(begin.ids, begin.idCount))
        return part
    }

    private fun simulationOf(setup: ScenarioSetup, begin: Begin): Simulation {
        val scenario = setup.scenario
        sendsRecords = begin.records
        if (begin.tally >= 0) tally = StepTally.of(begin.tally)
        val forcing = setup.collisions(engine, sendsRecords || tally != null)
        // Whatever can fail in a step is done then; only if that holds for all nodes does the step stand.
        val agreement = Output { turns.tell({}) { _, _ -> } }
        return Simulation(
            population,
            setup.boundary,
            forcing,
            sharedTimeStep(setup.timeStep),
            setup.forces,
            listOf(agreement),
            begin.time,
            begin.step,
            scenario.startTime,
            null,
            scenario.clock,
            NodePartition(turns),
            setup.sources,
        )
    }

    private fun sharedTimeStep(timeStep: TimeStep): TimeStep = when (timeStep) {
        is FreePathTimeStep -> StoppingSharedTimeStep(SharedTimeStep(timeStep, turns, engine.loop), timeStep.stops)
        is PerSphereTimeStep -> SharedTimeStep(timeStep, turns, engine.loop)
        else -> timeStep
    }

    private fun serve(sums: NodeSums) {
        while (true) {
            val question = mail.receive(Mail.LEADER)
            when (Command.entries[question.get().toInt()]) {
                Command.STEP -> step()
                Command.GATHER -> SpheresWire.send(mail, Mail.LEADER, population)
                Command.FIRST_SUMS -> mail.send(Mail.LEADER, sums.first(simulation.time))
                Command.CENTRAL_SUMS -> mail.send(Mail.LEADER, sums.central(question))
                Command.NUMBER -> mail.send(Mail.LEADER, number(question))
            }
        }
    }

    private fun number(question: ByteBuffer): ByteBuffer {
        val number = CommonNumber.entries[question.get().toInt()].of(simulation, question.int)
        return MessageWriter().double(number).message()
    }

    private fun step() {
        val before = CollisionCounters().also { it.set(counters) }
        val began = System.nanoTime()
        val answer = try {
            simulation.advance()
            done((System.nanoTime() - began) * 1e-9, before)
        } catch (e: MailClosedException) {
            throw e
        } catch (e: InterruptedException) {
            throw e
        } catch (e: TornTurnException) {
            // The crew ends with this node's work.
            throw e
        } catch (e: NodeFailedException) {
            MessageWriter().byte(Answer.FAILED_ELSEWHERE.ordinal).text("").text(e.message.orEmpty())
        } catch (e: Throwable) {
            turns.fail(e)
            failed(e)
        }
        mail.send(Mail.LEADER, answer.message())
    }

    /** The answer after a step that stands, so that the others wait for no turn. */
    private fun done(seconds: Double, before: CollisionCounters): MessageWriter = try {
        val collisions = simulation.collisions!!
        val done = StepDone(
            simulation.time,
            simulation.lastDuration,
            engine.total,
            population.size,
            seconds,
            carried.numbers,
            engine.cost,
            counters.since(before),
            collisions.record.takeIf { sendsRecords },
            tally?.also { it.take(collisions.record!!) },
            simulation.sources?.sums,
        )
        MessageWriter().byte(Answer.DONE.ordinal).stepDone(done)
    } catch (e: Throwable) {
        // Such as for lack of memory: the leader sees that not all have failed.
        failed(e)
    }

    private fun failed(e: Throwable) =
        MessageWriter().byte(Answer.FAILED.ordinal).text(e.javaClass.name).text(e.message ?: e.javaClass.name)

    private companion object {
        const val SOURCE = "the scenario of the run"
    }
}

/** A [PerSphereTimeStep] for the spheres of all nodes. */
private class SharedTimeStep(
    private val timeStep: PerSphereTimeStep,
    private val turns: Turns,
    private val loop: RangeLoop,
) : TimeStep {
    override fun next(population: Population): Double {
        val measured = turns.gather(doubleArrayOf(timeStep.measure(population, loop)))
        return timeStep.next(measured.map { it[0] }.reduce(timeStep::combine))
    }
}

/** The same, whose steps end at [stops]. */
private class StoppingSharedTimeStep(shared: SharedTimeStep, override val stops: Stops) :
    StoppingTimeStep,
    TimeStep by shared
