package daphnis.core.cluster.bricks

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population

/**
 * A dense gas (φ = 0.47) in a long thin box. Within a step of [DT] a sphere has a few collisions, and chains of them
 * reach far beyond the sight of a brick that is cut across the length.
 */
internal class LongBox(seed: Long, long: Int = 50) {
    private val random = SeededRandom(seed)
    private val isSheared = random.nextInt(3) == 0
    private val counts = if (isSheared) intArrayOf(4, long, 4) else intArrayOf(long, 4, 4)
    private val box = Box(0.0, 0.0, 0.0, APART * counts[0], APART * counts[1], APART * counts[2])

    val boundary: BoundaryConditions = when {
        isSheared -> LeesEdwards(box, 0.3)
        random.nextInt(2) == 0 -> Walls(box, 0.9, booleanArrayOf(true, false, false))
        else -> Periodic(box)
    }
    val population = populate()

    /** Into [parts] parts across the length. */
    fun slabs(parts: Int) = if (isSheared) BrickDivision(1, parts, 1) else BrickDivision(parts, 1, 1)

    private fun populate(): Population {
        val n = counts[0] * counts[1] * counts[2]
        fun at(k: Int) = APART * (k + 0.5) + 0.01 * random.nextDouble(-1.0, 1.0)
        fun gauss() = DoubleArray(n) { random.nextGaussian() }
        return Population(
            DoubleArray(n) { at(it % counts[0]) },
            DoubleArray(n) { at(it / counts[0] % counts[1]) },
            DoubleArray(n) { at(it / counts[0] / counts[1]) },
            gauss(),
            gauss(),
            gauss(),
            DoubleArray(n) { 0.5 },
            DoubleArray(n) { 1.0 },
        )
    }

    companion object {
        const val DT = 0.15
        private const val APART = 1.04
    }
}
