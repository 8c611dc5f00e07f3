package daphnis.core.force.thermostat

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Open
import daphnis.core.population.PartialSums
import daphnis.core.population.Population
import kotlin.math.sqrt

/**
 * Scales velocities at the end of each step, relative to the flow and to the mean over all spheres, so that their
 * temperature becomes [temperature]: at once, or as it would relax within [time] (Berendsen, Postma, van Gunsteren,
 * DiNola & Haak 1984, J. Chem. Phys. 81, 3684). The temperature is Σ m w²/d(N − 1) along d axes. Momentum is conserved. Spheres which
 * are all at rest relative to their mean stay so, and fewer than two are left alone.
 *
 * @property temperature T, mass · (length/time)²
 * @property time of relaxation; 0 for at once
 * @throws IllegalArgumentException when a number is negative or not finite
 */
public class Rescaling @JvmOverloads constructor(
    public val temperature: Double,
    public val time: Double = 0.0,
    override val boundary: BoundaryConditions = Open,
    override val firstBody: Int = Int.MAX_VALUE,
) : Thermostat() {
    init {
        require(temperature >= 0 && temperature.isFinite()) { "temperature is $temperature; it must be at least 0" }
        require(time >= 0 && time.isFinite()) { "time is $time; it must be at least 0" }
    }

    // N, Σ m, Σ m w² and Σ m w.
    private val sums = PartialSums(SUMS) { from, to, into, block ->
        val p = population!!
        block.addBlocks(from, to, into[COUNT]) { first, end, terms ->
            for (k in first until end) terms[k - first] = if (isBody(p.id[k])) 0.0 else 1.0
        }
        block.addBlocks(from, to, into[MASS]) { first, end, terms ->
            for (k in first until end) terms[k - first] = massOf(p, k)
        }
        block.addBlocks(from, to, into[SQUARE]) { first, end, terms ->
            for (k in first until end) terms[k - first] = massOf(p, k) * square(p, k)
        }
        for (axis in 0 until axes) {
            block.addBlocks(from, to, into[MOMENTUM + axis]) { first, end, terms ->
                for (k in first until end) terms[k - first] = massOf(p, k) * peculiar(p, k, axis)
            }
        }
    }
    private var population: Population? = null

    /** Nothing: all is done at the end of the step. */
    override fun beforeDrift(population: Population, start: Double, duration: Double): Unit = Unit

    override fun afterDrift(population: Population, end: Double, duration: Double): Unit =
        act(population, end, duration, SECOND_HALF)

    override fun act(population: Population, time: Double, duration: Double, half: Int) {
        this.population = population
        try {
            sums.take(population.size, loop)
        } finally {
            this.population = null
        }
        sums.mergeAll(partition)
        val count = sums.value(COUNT)
        val mass = sums.value(MASS)
        if (count < 2) return
        val mean = DoubleArray(AXES) { sums.value(MOMENTUM + it) / mass }
        var heat = sums.value(SQUARE)
        for (axis in 0 until axes) heat -= mean[axis] * sums.value(MOMENTUM + axis)
        val now = heat / (axes * (count - 1))
        if (!(now > 0)) return
        val wanted =
            if (this.time ==
                0.0
            ) {
                temperature
            } else {
                temperature + (now - temperature) * StrictMath.exp(-duration / this.time)
            }
        scale(population, mean, sqrt(wanted / now))
    }

    private fun scale(p: Population, mean: DoubleArray, factor: Double) {
        loop.runLight(p.size) { _, from, to ->
            for (k in from until to) {
                if (isBody(p.id[k])) continue
                for (axis in 0 until axes) {
                    val still = flowAt(p, k, axis) + mean[axis]
                    val v = p.velocity(axis)
                    v[k] = still + factor * (v[k] - still)
                }
            }
        }
    }

    private fun massOf(p: Population, k: Int) = if (isBody(p.id[k])) 0.0 else p.mass[k]

    private fun peculiar(p: Population, k: Int, axis: Int) = p.velocity(axis)[k] - flowAt(p, k, axis)

    private fun square(p: Population, k: Int): Double {
        var sum = 0.0
        for (axis in 0 until axes) sum += peculiar(p, k, axis).let { it * it }
        return sum
    }

    private companion object {
        const val AXES = 3
        const val COUNT = 0
        const val MASS = 1
        const val SQUARE = 2
        const val MOMENTUM = 3
        const val SUMS = 6
    }
}
