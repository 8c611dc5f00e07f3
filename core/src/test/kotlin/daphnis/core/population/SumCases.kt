package daphnis.core.population

import daphnis.core.initial.SeededRandom

/** Populations that are hard on sums. */
object SumCases {
    /** Spheres with numbers drawn by [draw]; masses are positive. */
    fun population(count: Int, random: SeededRandom, draw: (SeededRandom) -> Double): Population {
        fun column() = DoubleArray(count) { draw(random) }
        val mass = DoubleArray(count) { 0.1 + random.nextDouble() }
        val radius = DoubleArray(count) { 0.1 }
        return Population(
            column(), column(), column(), column(), column(), column(), radius, mass,
            IntArray(count) {
                it
            },
        )
    }

    fun gas(count: Int, seed: Long): Population = population(count, SeededRandom(seed)) { it.nextGaussian() + 0.3 }

    /** Ways to draw coordinates and velocities, whose squares are finite. */
    enum class Numbers(val draw: (SeededRandom) -> Double) {
        ORDINARY({ it.nextGaussian() + 0.3 }),
        WIDE({ Math.scalb(it.nextGaussian(), it.nextInt(400) - 200) }),
        SUBNORMAL({ Double.fromBits(it.nextLong() and ((1L shl 52) - 1)) * if (it.nextInt(2) == 0) 1 else -1 }),
        CANCELLING({ listOf(1e150, -1e150, 1.0, -1.0, 1e-150, -1e-150, 3e-300)[it.nextInt(7)] }),
        ZEROS({ if (it.nextInt(2) == 0) 0.0 else -0.0 }),
    }
}
