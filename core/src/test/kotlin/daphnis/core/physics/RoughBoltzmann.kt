package daphnis.core.physics

import daphnis.core.initial.SeededRandom
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * Boltzmann's equation for a uniform gas of solid rough spheres of diameter 1 and mass 1, by direct simulation Monte
 * Carlo: pairs are drawn one at a time, in proportion to their relative speed, and hit each other at a place drawn in
 * proportion to the speed of approach (Bird 1994, Molecular Gas Dynamics). There is no time step, so the only errors are
 * those of a finite number of spheres. It shares no code with what it is a target of.
 *
 * @param alpha coefficient of normal restitution
 * @param beta coefficient of tangential restitution
 * @param ratio T_rot/T_tr of the start, from which spins are drawn as Gaussians
 */
internal class RoughBoltzmann(
    private val count: Int,
    private val alpha: Double,
    private val beta: Double,
    ratio: Double,
    seed: Long,
) {
    /** @property ratio T_rot/T_tr, which is E_rot/E_kin */
    class Target(val alpha: Double, val beta: Double, val ratio: Double)

    private val random = SeededRandom(seed)

    // Six numbers for each sphere: v, ω.
    private val state = DoubleArray(6 * count) {
        (if (it % 6 < 3) 1.0 else sqrt(ratio / INERTIA)) *
            random.nextGaussian()
    }
    private var fastest = 9.0

    /** T_rot/T_tr. */
    val ratio: Double get() = INERTIA * squares(3) / squares(0)

    private fun squares(from: Int): Double {
        var sum = 0.0
        for (k in 0 until count) for (a in from until from + 3) sum += state[6 * k + a] * state[6 * k + a]
        return sum
    }

    /** [each] collisions of each sphere, after which velocities and spins are scaled: the gas cools. */
    fun cool(each: Double) {
        collide((each * count / 2).toLong())
        rest()
        val factor = 1 / sqrt(squares(0) / count / 3)
        for (k in state.indices) state[k] *= factor
    }

    /** [each] collisions of each sphere, with white noise between them that gives back the energy of motion. */
    fun drive(each: Double) {
        repeat(KICKS) {
            collide((each * count / 2 / KICKS).toLong())
            val sigma = sqrt(maxOf(0.0, 1 - squares(0) / count / 3))
            for (k in 0 until count) for (a in 0..2) state[6 * k + a] += sigma * random.nextGaussian()
            rest()
        }
    }

    /** Takes the mean velocity off, which does not cool. */
    private fun rest() {
        for (a in 0..2) {
            val mean = (0 until count).sumOf { state[6 * it + a] } / count
            for (k in 0 until count) state[6 * k + a] -= mean
        }
    }

    private fun collide(collisions: Long) {
        val u = DoubleArray(3)
        val n = DoubleArray(3)
        var done = 0L
        while (done < collisions) {
            val i = 6 * (random.nextDouble() * count).toInt()
            val j = 6 * (random.nextDouble() * count).toInt()
            if (i == j) continue
            for (a in 0..2) u[a] = state[j + a] - state[i + a]
            val speed = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2])
            fastest = maxOf(fastest, speed)
            if (random.nextDouble() * fastest >= speed) continue
            place(u, speed, n)
            impact(i, j, u, n)
            done++
        }
    }

    /** Draws the normal [n] from the first to the second sphere, whose angle to −[u] has a cosine² that is uniform. */
    private fun place(u: DoubleArray, speed: Double, n: DoubleArray) {
        val square = random.nextDouble()
        val along = -sqrt(square) / speed
        val across = sqrt(1 - square)
        val angle = 2 * PI * random.nextDouble()
        // Two directions across u.
        val a = if (abs(u[0]) < 0.6 * speed) 0 else 1
        val b = (a + 1) % 3
        val c = (a + 2) % 3
        val length = sqrt(u[b] * u[b] + u[c] * u[c])
        val first = across * cos(angle) / length
        val second = across * sin(angle) / (length * speed)
        n[a] = along * u[a] + second * (u[b] * u[b] + u[c] * u[c])
        n[b] = along * u[b] + first * u[c] - second * u[a] * u[b]
        n[c] = along * u[c] - first * u[b] - second * u[a] * u[c]
    }

    private fun impact(i: Int, j: Int, u: DoubleArray, n: DoubleArray) {
        val approach = u[0] * n[0] + u[1] * n[1] + u[2] * n[2]
        val push = DoubleArray(3)
        for (a in 0..2) {
            val b = (a + 1) % 3
            val c = (a + 2) % 3
            val spin =
                (state[i + 3 + b] + state[j + 3 + b]) / 2 * n[c] - (state[i + 3 + c] + state[j + 3 + c]) / 2 * n[b]
            push[a] = (1 + beta) / 7 * (u[a] - approach * n[a] - spin)
        }
        for (a in 0..2) {
            val b = (a + 1) % 3
            val c = (a + 2) % 3
            val turn = (n[b] * push[c] - n[c] * push[b]) / (2 * INERTIA)
            state[i + 3 + a] += turn
            state[j + 3 + a] += turn
            val change = push[a] + (1 + alpha) / 2 * approach * n[a]
            state[i + a] += change
            state[j + a] -= change
        }
    }

    companion object {
        private const val INERTIA = 0.1
        private const val KICKS = 10

        /**
         * Gases that cool: means of six runs of 50,000 spheres and 4,000 collisions of each, with errors of 1, 1, 3 and
         * 4 in the last digit. Theory with Maxwellian velocities (Huthmann & Zippelius 1997, Phys. Rev. E 56, R6275) has
         * .574, .867, 1.447 and 2.060.
         */
        val COOLING = listOf(
            Target(0.9, 0.0, 0.5462),
            Target(0.9, 0.5, 0.8523),
            Target(0.8, -0.5, 1.2906),
            Target(0.5, 0.0, 1.8882),
        )

        /**
         * Gases that are driven, from 20,000 spheres and 400 collisions of each, with errors of 1 in the last digit but
         * one. With Maxwellian velocities the ratio is 2(1 + β)/(14 − 5(1 + β)): .0148, .0870, .2222 and .4615
         * (Morishima & Salo 2004, whose ε_t is −β).
         */
        val DRIVEN = listOf(
            Target(0.9, -0.9, 0.01461),
            Target(0.9, -0.5, 0.0842),
            Target(0.9, 0.0, 0.2141),
            Target(0.9, 0.5, 0.4503),
        )
    }
}
