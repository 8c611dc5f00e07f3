package daphnis.core.wall

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.WallImpact
import daphnis.core.random.CounterRandom
import daphnis.core.space.Space
import kotlin.math.sqrt

/**
 * Gives spheres that meet a wall the velocities of a gas of its temperature, see [WallFace]. What
 * is drawn follows from the seed, the face, the id of the sphere, the time of the impact to the bit, and the
 * [StepRows.streak] of the sphere, so that it is the same in every engine, on every node and in a run that is resumed.
 * Without the streak a sphere in an acute corner, which another wall sends back at once, would get the same velocity
 * again and again.
 */
internal class ThermalWall(
    private val number: Int,
    private val temperature: Double,
    private val space: Space,
    seed: Long,
) {
    private val ofSteps = CounterRandom(seed)

    /** The seed of the present step. */
    private var seed = 0L

    /** A step begins at [start]. */
    fun begin(start: Double) {
        ofSteps.draw(number, start, WALLS)
        seed = ofSteps.word(0).toLong() shl 32 or (ofSteps.word(1).toLong() and WORD)
    }

    /**
     * Draws the velocity of [slot] along a face of the box, which is the wall, and returns the speed with which it
     * leaves. Several threads may call.
     */
    fun drawAtFace(rows: StepRows, slot: Int, time: Double): Double {
        val random = random(rows, slot, time)
        val sigma = sqrt(temperature / rows.mass[slot])
        var word = 0
        for (k in 0 until space.dimensions) {
            if (k != number shr 1) rows.state[slot * STRIDE + VX + k] = sigma * random.gaussian(word++)
        }
        return sigma * sqrt(-2.0 * StrictMath.log(random.uniform(word)))
    }

    private fun random(rows: StepRows, slot: Int, time: Double) =
        CounterRandom(seed).apply { draw(rows.id[slot], time, rows.streak(slot) - 1) }

    /**
     * The same at a wall with the unit normal and the velocity of [impact]: the velocity of [slot] along the normal
     * becomes 0, relative to the wall, and the speed is returned.
     */
    fun draw(rows: StepRows, slot: Int, impact: WallImpact): Double {
        val random = random(rows, slot, impact.time)
        val sigma = sqrt(temperature / rows.mass[slot])
        val x = sigma * random.gaussian(0)
        val y = sigma * random.gaussian(1)
        val z = if (space.isPlane) 0.0 else sigma * random.gaussian(2)
        val across = x * impact.nx + y * impact.ny + z * impact.nz
        val v = slot * STRIDE + VX
        rows.state[v] = x - across * impact.nx + impact.sx
        rows.state[v + 1] = y - across * impact.ny + impact.sy
        rows.state[v + 2] = z - across * impact.nz + impact.sz
        return sigma * sqrt(-2.0 * StrictMath.log(random.uniform(3)))
    }

    private companion object {
        const val WORD = 0xffffffffL

        /** Keeps these numbers apart from those of thermostats, whose streams are halves of steps. */
        const val WALLS = 2
    }
}
