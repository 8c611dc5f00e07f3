package daphnis.core.engine.lists

import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population

/** 512 spheres near the sites of a cubic lattice. */
internal fun crowd(apart: Double = 1.05, jitter: Double = 0.01): Population {
    val random = SeededRandom(3)
    val n = 512
    fun gauss() = DoubleArray(n) { random.nextGaussian() }
    fun at(c: Int) = apart * (c - 3.5) + jitter * random.nextDouble(-1.0, 1.0)
    return Population(
        DoubleArray(n) { at(it % 8) },
        DoubleArray(n) { at(it / 8 % 8) },
        DoubleArray(n) { at(it / 64) },
        gauss(),
        gauss(),
        gauss(),
        DoubleArray(n) { 0.5 },
        DoubleArray(n) { 1.0 },
    )
}
