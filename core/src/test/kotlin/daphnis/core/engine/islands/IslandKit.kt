package daphnis.core.engine.islands

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Open
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import java.util.concurrent.atomic.AtomicIntegerArray

/** A step of unit length with elastic collisions. */
internal fun stepOf(population: Population, boundary: BoundaryConditions = Open): CollisionStep {
    val step = CollisionStep(population, boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters())
    return step.apply { duration = 1.0 }
}

/** What [workers] share at the beginning of such a step, whose one window is all of it. */
internal fun fieldOf(population: Population, boundary: BoundaryConditions = Open, workers: Int = 2): IslandField {
    val step = stepOf(population, boundary)
    return IslandField(workers).apply {
        measure(step)
        prepare()
        windowEnd = 1.0
    }
}

/** Calls [action] with the worker's number, 0 or 1, and each of [turns] in turn, on two threads in step. */
internal fun inStep(turns: Int, action: (worker: Int, turn: Int) -> Unit) {
    val reached = AtomicIntegerArray(2 * APART)
    FixedPool(2).use { pool ->
        pool.run { worker ->
            for (turn in 0 until turns) {
                reached.set(worker * APART, turn + 1)
                var spins = 0
                while (reached.get((1 - worker) * APART) <= turn) if (++spins % SPINS == 0) Thread.yield()
                action(worker, turn)
            }
        }
    }
}

/** Numbers between two that different threads write, so that they lie in different cache lines. */
private const val APART = 64
private const val SPINS = 2000
