package daphnis.core.engine

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Walls
import daphnis.core.force.Force
import daphnis.core.force.UniformAcceleration
import daphnis.core.initial.SeededRandom
import daphnis.core.surface.Roughness
import daphnis.core.wall.WallFace
import daphnis.core.wall.WallMotion

/**
 * Walls of a drawn case that move or are thermal, in half of all, and gravity between walls, in half of all. They have
 * random numbers of their own, so that what else is drawn from [seed] is as without them.
 */
class WallDraw(private val seed: Long) {
    private val random = SeededRandom(seed + APART)
    private val isDriven = random.nextInt(2) == 0
    private val falls = random.nextInt(2) == 0

    /** What the faces of walls with [roughness] across the axes [walled] have of their own. */
    fun faces(roughness: List<Roughness?>, walled: BooleanArray = booleanArrayOf(true, true, true)): List<WallFace?> {
        if (!isDriven) return emptyList()
        return List(FACES) { face ->
            if (!walled[face shr 1] || random.nextInt(3) == 0) return@List null
            val restitution = if (random.nextInt(2) == 0) null else random.nextDouble()
            val isThermal = roughness.getOrNull(face) == null && random.nextInt(3) == 0
            WallFace(restitution, motion(), if (isThermal) random.nextDouble(0.1, 2.0) else null)
        }
    }

    private fun motion(): WallMotion? {
        val amplitude = Math.exp(random.nextDouble(Math.log(1e-3), Math.log(0.1)))
        val frequency = random.nextDouble(0.01, 0.3) / amplitude
        val phase = random.nextDouble(-1.0, 1.0)
        return when (random.nextInt(5)) {
            0 -> null
            1 -> WallMotion.Steady(0.1 * random.nextGaussian())
            2 -> WallMotion.Sawtooth(amplitude, frequency, phase, random.nextDouble(0.1, 0.9))
            3 -> WallMotion.BiParabolic(amplitude, frequency, phase)
            else -> WallMotion.Sine(amplitude, frequency, phase)
        }
    }

    /** Gravity between walls: in a step of [dt] it changes velocities by up to three. */
    fun forces(boundary: BoundaryConditions, dt: Double): List<Force> {
        if (!falls || boundary !is Walls) return emptyList()
        val random = SeededRandom(seed + FALLING)
        fun component() = if (random.nextInt(2) == 0) 0.0 else Math.exp(random.nextDouble(-6.0, 1.0)) / dt
        return listOf(UniformAcceleration(component(), -component(), -component()))
    }

    private companion object {
        const val APART = 1L shl 44
        const val FALLING = 1L shl 45
        const val FACES = 6
    }
}
