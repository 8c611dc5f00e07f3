package daphnis.core.force.thermostat

import daphnis.core.population.PartialSums
import daphnis.core.population.Population
import daphnis.core.population.Workers
import daphnis.core.random.CounterRandom

/**
 * A thermostat that draws new velocities, sphere by sphere.
 *
 * @param seed of its numbers; two thermostats of one simulation need two
 * @property conservesMomentum whether Σ m v over the spheres it acts on stays as it was: then all of them get the
 *   velocity that takes back the sum of the kicks
 */
public sealed class RandomKicks(seed: Long, public val conservesMomentum: Boolean) : Thermostat() {
    private val random = Workers { CounterRandom(seed) }

    // Σ m and Σ m Δv of the present half step.
    private val sums = PartialSums(SUMS) { from, to, into, block ->
        val p = population!!
        for (axis in 0 until axes) {
            block.addBlocks(from, to, into[axis]) { first, end, terms ->
                for (k in first until end) terms[k - first] = p.mass[k] * kicks[axis][k]
            }
        }
        block.addBlocks(from, to, into[MASS]) { first, end, terms ->
            for (k in first until end) terms[k - first] = if (isBody(p.id[k])) 0.0 else p.mass[k]
        }
    }
    private var population: Population? = null
    private var kicks = Array(AXES) { DoubleArray(0) }

    /** Prepares kicks for [duration]. */
    internal abstract fun prepare(duration: Double)

    /**
     * The change of the velocity [w] relative to the flow of a sphere of [mass] along an axis, from the numbers that
     * [drawn] has for the sphere; [word] is the axis's.
     */
    internal abstract fun kick(w: Double, mass: Double, drawn: CounterRandom, word: Int): Double

    final override fun act(population: Population, time: Double, duration: Double, half: Int) {
        prepare(duration)
        random.upTo(loop.workers)
        if (conservesMomentum && kicks[0].size < population.size) kicks = Array(AXES) { DoubleArray(population.size) }
        loop.run(population.size) { worker, from, to -> kick(population, time, half, random[worker], from, to) }
        if (conservesMomentum) takeBackMean(population)
    }

    private fun kick(p: Population, time: Double, half: Int, drawn: CounterRandom, from: Int, to: Int) {
        for (k in from until to) {
            if (isBody(p.id[k])) {
                if (conservesMomentum) for (axis in 0 until axes) kicks[axis][k] = 0.0
                continue
            }
            drawn.draw(p.id[k], time, half)
            for (axis in 0 until axes) {
                val v = p.velocity(axis)
                val change = kick(v[k] - flowAt(p, k, axis), p.mass[k], drawn, axis)
                v[k] += change
                if (conservesMomentum) kicks[axis][k] = change
            }
        }
    }

    private fun takeBackMean(p: Population) {
        population = p
        try {
            sums.take(p.size, loop)
        } finally {
            population = null
        }
        sums.mergeAll(partition)
        val mass = sums.value(MASS)
        if (mass == 0.0) return
        for (axis in 0 until axes) {
            val mean = sums.value(axis) / mass
            val v = p.velocity(axis)
            loop.runLight(p.size) { _, from, to ->
                for (k in from until to) if (!isBody(p.id[k])) v[k] -= mean
            }
        }
    }

    private companion object {
        const val AXES = 3
        const val MASS = 3
        const val SUMS = 4
    }
}
