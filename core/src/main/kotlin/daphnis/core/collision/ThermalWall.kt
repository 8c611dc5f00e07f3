package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.initial.SeededRandom
import kotlin.math.sqrt

/**
 * Gives spheres that meet a wall the velocities of a gas of its temperature, see [daphnis.core.boundary.WallFace]. What
 * is drawn follows from the seed, the face, the id of the sphere and the time of the impact to the bit, so that it is
 * the same in every engine, on every node and in a run that is resumed.
 */
internal class ThermalWall(private val face: Int, private val temperature: Double, private val seed: Long) {
    private var start = 0.0

    /** A step begins at [start]. */
    fun begin(start: Double) {
        this.start = start
    }

    /** Draws the velocity of [slot] along the wall, and returns the speed with which it leaves. */
    fun draw(rows: StepRows, slot: Int, time: Double): Double {
        val random = SeededRandom(key(rows.id[slot], time))
        val sigma = sqrt(temperature / rows.mass[slot])
        val axis = face shr 1
        for (k in 0..2) if (k != axis) rows.state[slot * STRIDE + VX + k] = sigma * random.nextGaussian()
        return sigma * sqrt(-2.0 * StrictMath.log(1.0 - random.nextDouble()))
    }

    private fun key(id: Int, time: Double): Long {
        val ofSphere = mixed(mixed(seed + face) + id)
        return mixed(mixed(ofSphere + start.toRawBits()) + time.toRawBits())
    }

    private companion object {
        /** The last part of SplitMix64, one to one and with every bit in all. */
        fun mixed(bits: Long): Long {
            var r = bits + -0x61c8864680b583ebL
            r = (r xor (r ushr 30)) * -0x40a7b892e31b1a47L
            r = (r xor (r ushr 27)) * -0x6b2fb644ecceee15L
            return r xor (r ushr 31)
        }
    }
}
