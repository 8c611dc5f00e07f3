package daphnis.actors

import com.typesafe.config.ConfigFactory
import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.actors.region.Phase
import daphnis.actors.region.RegionCommand
import daphnis.actors.region.RegionLayout
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.digests
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.simulationOf
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import kotlinx.coroutines.CoroutineDispatcher
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.javadsl.Behaviors
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** What the tests of faults share: a small gas, its right digests, and both engines with something wrong inside. */
internal object FaultKit {
    val layout = RegionLayout.Stretches(5)
    const val DURATION = 0.2

    fun simulation(engine: CollisionEngine, restitution: Restitution = ConstantRestitution(1.0)): Simulation {
        val (p, boundary) = gas(400, 4)
        return simulationOf(p, boundary, DURATION, restitution, engine = engine)
    }

    /** One step of the same gas, without the loop around it. */
    fun step(restitution: Restitution = ConstantRestitution(1.0)): CollisionStep {
        val (p, boundary) = gas(400, 4)
        return CollisionStep(p, boundary, CollisionLaw(restitution), CollisionCounters()).also {
            it.duration = DURATION
        }
    }

    /** That step, done. */
    val done: CollisionStep = step().also { SerialEngine().advance(it) }

    /** The digests after steps 1, 2, … */
    val expected = digests(simulation(SerialEngine()), 4)

    /** The digest at the start. */
    val initial = stateDigest(simulation(SerialEngine()).population)

    fun assertWorksOn(simulation: Simulation, about: () -> String) {
        for (digest in expected.drop(simulation.step.toInt())) {
            simulation.advance()
            assertEquals(digest, stateDigest(simulation.population), about)
        }
    }

    /** A dense gas that engines take by neighbour lists: a cubic lattice of [edge]³ spheres, set in motion. */
    fun crowd(edge: Int = 17): Pair<Population, BoundaryConditions> {
        val distance = 1.05
        val random = SeededRandom(2)
        fun at(c: Int) = distance * (c - edge / 2)
        val spheres = List(edge * edge * edge) { k ->
            fun v() = random.nextGaussian()
            Sphere(at(k % edge), at(k / edge % edge), at(k / (edge * edge)), v(), v(), v(), r = 0.5)
        }
        val length = distance * edge
        return populationOf(*spheres.toTypedArray()) to Periodic(Box.centred(length, length, length))
    }

    fun setPatience(engine: CollisionEngine, nanos: Long) {
        when (engine) {
            is RegionActorEngine -> engine.patience = nanos
            is PekkoEngine -> engine.patience = nanos
        }
    }

    fun actorSystem(): ActorSystem<Void> {
        val settings = "pekko.loglevel=OFF, pekko.stdout-loglevel=OFF, pekko.daemonic=on"
        val config = ConfigFactory.parseString(settings).withFallback(ConfigFactory.load())
        return ActorSystem.create(Behaviors.empty<Void>(), "host", config)
    }

    /** Threads that engines made. */
    fun engineThreads(): List<Thread> =
        Thread.getAllStackTraces().keys.filter { it.isAlive && it.name.startsWith("daphnis") }

    /** Waits until no engine has a thread. Who leaks one fails by the test's time limit, after saying so here. */
    fun awaitNoEngineThreads() {
        val end = System.nanoTime() + 20_000_000_000
        while (engineThreads().isNotEmpty() && System.nanoTime() < end) Thread.sleep(20)
        assertTrue(engineThreads().isEmpty()) { "left behind: ${engineThreads().map { it.name }}" }
    }
}

/**
 * What tests of faults that are run for both ways of taking a step have in common.
 *
 * @param shares whether regions share epochs; else they grow islands
 */
abstract class BothWays(private val shares: Boolean) {
    /** What regions are told in steps of this kind. */
    protected val phases: List<Phase> = Phase.entries.filter { (it == Phase.SHARE) == shares }

    /** The last thing that they are told. */
    protected val lastPhase: Phase = if (shares) Phase.SHARE else Phase.COMMIT

    protected fun engines(probe: (RegionCommand) -> Unit = {}): List<CollisionEngine> =
        listOf(actors().also { it.probe = probe }, pekko().also { it.probe = probe })

    protected fun actors(threads: Int = 2, dispatcher: CoroutineDispatcher? = null): RegionActorEngine =
        RegionActorEngine(threads, FaultKit.layout, dispatcher).also {
            it.fewest = if (shares) 0 else Int.MAX_VALUE
            it.tuning = tuning
        }

    protected fun pekko(threads: Int = 2, host: ActorSystem<*>? = null): PekkoEngine =
        PekkoEngine(threads, FaultKit.layout, host).also {
            it.fewest = if (shares) 0 else Int.MAX_VALUE
            it.tuning = tuning
        }

    private val tuning =
        HorizonTuning(steps = 3, classBound = 3.0, deviation = 0.0, cellsAlong = 2.0, cellsAcross = 1.0)
}

/** Throws [e] whatever it is, as code may that was not written in Kotlin. */
internal fun throwAny(e: Throwable): Nothing = throw e
