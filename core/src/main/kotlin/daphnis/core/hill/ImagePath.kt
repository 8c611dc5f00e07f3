package daphnis.core.hill

import daphnis.core.orbit.OrbitalFrequencies

/**
 * The path of the image one box away in a sheet that is perturbed, relative to its original. It is an epicycle with the
 * guiding centre [length] and the amplitude q · [length], which is at its inner end at time 0,
 *
 * ΔX = L (1 − q cos κt), ΔY = −s L t + 2 (Ω/κ) q L sin κt,
 *
 * with s the rate of shear: a solution of Hill's equations, which are linear, so that whoever moves freely has images
 * that do. It is how streamlines move past one another that all have the phase of one perturber, with q = a de/da
 * (Borderies, Goldreich & Tremaine 1983, Icarus 55, 124; Mosqueira 1996, Icarus 122, 128).
 *
 * @property length L, by which guiding centres are apart
 * @property q the nonlinearity, in [0, 1)
 */
internal class ImagePath(
    private val length: Double,
    private val frequencies: OrbitalFrequencies,
    private val q: Double,
) {
    private val kappa = frequencies.kappa

    /** The amplitude along y. */
    private val along = 2 / frequencies.radialFactor * q * length

    /** ΔX over [length] at [time]. */
    fun widening(time: Double): Double = 1 - q * StrictMath.cos(kappa * time)

    /** ΔY at [time]. */
    fun y(time: Double): Double = -frequencies.shearRate * length * time + along * StrictMath.sin(kappa * time)

    /** Of ΔX along the chord from [start] over [duration]; of ΔX itself where that is 0. */
    fun velocityX(start: Double, duration: Double): Double =
        q * length * kappa * StrictMath.sin(middle(start, duration)) * shortening(duration)

    /** The same of ΔY. */
    fun velocityY(start: Double, duration: Double): Double =
        -frequencies.shearRate * length + along * kappa * StrictMath.cos(middle(start, duration)) * shortening(duration)

    private fun middle(start: Double, duration: Double) = kappa * (start + duration / 2)

    /** A chord over the path of a circle, sin h / h for half the angle. */
    private fun shortening(duration: Double): Double {
        val half = kappa * duration / 2
        return if (half == 0.0) 1.0 else StrictMath.sin(half) / half
    }
}
