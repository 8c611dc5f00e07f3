package daphnis.actors

import com.typesafe.config.ConfigFactory
import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.collision.Restitution
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
import kotlinx.coroutines.CoroutineDispatcher
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.javadsl.Behaviors
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** What the tests of faults share: a small gas, its right digests, and both engines with something wrong inside. */
internal object FaultKit {
    const val REGIONS = 5
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

    private val tuning =
        HorizonTuning(steps = 3, classBound = 3.0, deviation = 0.0, cellsAlong = 2.0, cellsAcross = 1.0)

    /** Engines of whose steps every region has its share. */
    fun engines(probe: (Int) -> Unit = {}): List<CollisionEngine> =
        listOf(actors().also { it.probe = probe }, pekko().also { it.probe = probe })

    fun actors(threads: Int = 2, dispatcher: CoroutineDispatcher? = null): RegionActorEngine =
        RegionActorEngine(threads, REGIONS, dispatcher).also {
            it.fewest = 0
            it.tuning = tuning
        }

    fun pekko(threads: Int = 2, host: ActorSystem<*>? = null): PekkoEngine = PekkoEngine(threads, REGIONS, host).also {
        it.fewest = 0
        it.tuning = tuning
    }

    /** Engines whose steps the serial engine takes. */
    fun serialEngines(probe: (Int) -> Unit = {}): List<CollisionEngine> = listOf(
        actors().also {
            it.fewest = Int.MAX_VALUE
            it.probe = probe
        },
        pekko().also {
            it.fewest = Int.MAX_VALUE
            it.probe = probe
        },
    )

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

/** Throws [e] whatever it is, as code may that was not written in Kotlin. */
internal fun throwAny(e: Throwable): Nothing = throw e
