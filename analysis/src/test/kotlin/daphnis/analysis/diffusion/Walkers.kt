package daphnis.analysis.diffusion

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.format.Snapshot
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import kotlin.math.exp
import kotlin.math.sqrt

/** Particles that are moved by hand in a periodic cube of edge 5 around the origin, a state each unit of time. */
internal object Walkers {
    val BOUNDARY = Periodic(Box.centred(5.0, 5.0, 5.0))
    private val axes = List(3) { Coordinate.Position(it) }

    fun population(count: Int): Population {
        val all = Array(6) { DoubleArray(count) }
        val one = DoubleArray(count) { 1.0 }
        return Population(all[0], all[1], all[2], all[3], all[4], all[5], one.copyOf(), one)
    }

    /** Shows [see] [times] states of [count] walkers; those of a group make the same Gaussian steps of [step]. */
    fun walk(
        count: Int,
        times: Int,
        random: SeededRandom,
        step: Double,
        group: Int = 1,
        see: (Population, Double) -> Unit,
    ) {
        val p = population(count)
        for (axis in 0..2) for (k in 0 until count) p.position(axis)[k] = 5 * random.nextDouble() - 2.5
        for (t in 0 until times) {
            see(p, t.toDouble())
            for (axis in 0..2) {
                for (first in 0 until count step group) {
                    val d = step * random.nextGaussian()
                    for (k in first until minOf(count, first + group)) p.position(axis)[k] += d
                }
            }
            BOUNDARY.endStep(p, t + 1.0)
        }
    }

    fun trajectories(count: Int, times: Int, random: SeededRandom, step: Double, group: Int = 1): Trajectories =
        Trajectories(axes, IntArray(count) { it }).also { all ->
            walk(count, times, random, step, group) { p, t -> all.add(Snapshot.of(p, BOUNDARY, t.toLong(), t)) }
        }

    /** Velocities that forget at [rate], C = 3 exp(−rate t), states [step] apart; they are Gaussian (Ornstein–Uhlenbeck). */
    fun forgetting(count: Int, times: Int, random: SeededRandom, rate: Double, step: Double): Trajectories {
        val p = population(count)
        val kept = exp(-rate * step)
        val new = sqrt(1 - kept * kept)
        for (axis in 0..2) for (k in 0 until count) p.velocity(axis)[k] = random.nextGaussian()
        return velocities(p, times, step) { v -> for (k in v.indices) v[k] = kept * v[k] + new * random.nextGaussian() }
    }

    /** Of [p], whose velocities along each axis [next] changes from one time to the next. */
    fun velocities(p: Population, times: Int, step: Double, next: (DoubleArray) -> Unit): Trajectories =
        Trajectories(List(3) { Coordinate.Velocity(it) }, IntArray(p.size) { it }).also { all ->
            for (t in 0 until times) {
                all.add(Snapshot.of(p, BOUNDARY, t.toLong(), t * step))
                for (axis in 0..2) next(p.velocity(axis))
            }
        }
}
