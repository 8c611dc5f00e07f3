package daphnis.actors

import com.typesafe.config.ConfigFactory
import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.actors.region.RegionCommand
import daphnis.actors.region.RegionLayout
import daphnis.core.Simulation
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.collision.Restitution
import daphnis.core.digests
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.population.stateDigest
import daphnis.core.simulationOf
import daphnis.core.step.CollisionStep
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.javadsl.Behaviors
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** What the tests of faults share: a small gas, its right digests, and both engines with something wrong inside. */
internal object FaultKit {
    val layout = RegionLayout.Stretches(5)
    const val DURATION = 0.2

    fun engines(probe: (RegionCommand) -> Unit = {}): List<CollisionEngine> = listOf(
        RegionActorEngine(2, layout).also { it.probe = probe },
        PekkoEngine(2, layout).also { it.probe = probe },
    )

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
