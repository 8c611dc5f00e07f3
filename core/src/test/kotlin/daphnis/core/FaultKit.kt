package daphnis.core

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.cluster.bricks.BrickDivision
import daphnis.core.cluster.bricks.BricksTogether
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.force.Force
import daphnis.core.parallel.ExecutorHandler
import daphnis.core.parallel.FixedPool
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows

/** A gas on every engine of the core, and what becomes of it undisturbed. */
abstract class FaultKit {
    protected val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
    protected val gas = randomSpheres(300, boundary, 2, 1.0) { 0.4 }

    protected val engines: List<() -> CollisionEngine?> = listOf(
        { null },
        { SerialEngine() },
        { IslandsEngine(3) },
        { IslandsEngine(FixedPool(3), fewest = 0) },
        { BricksTogether(FixedPool(3), BrickDivision(2, 1, 2)) },
        { ThreadPoolEngine(3) },
        { IslandsEngine(ExecutorHandler({ it.run() }, 2), fewest = 0) },
    )

    protected fun simulation(
        engine: CollisionEngine?,
        restitution: Restitution = ConstantRestitution(0.9),
        forces: List<Force> = emptyList(),
        outputs: List<Output> = emptyList(),
    ): Simulation {
        val collisions = engine?.let { CollisionForcing(restitution, engine = it) }
        return Simulation(gas.copy(), boundary, collisions, FixedTimeStep(0.3), forces, outputs)
    }

    /** Digests after 0, 1, 2, … steps of an undisturbed simulation with [forces]. */
    protected fun digests(steps: Int, hasEngine: Boolean = true, forces: List<Force> = emptyList()): List<String> {
        val s = simulation(if (hasEngine) SerialEngine() else null, forces = forces)
        return listOf(stateDigest(s.population)) + digests(s, steps)
    }

    protected fun assertRefused(message: String, action: () -> Unit) {
        assertEquals(message, assertThrows(IllegalStateException::class.java, action).message)
    }
}
