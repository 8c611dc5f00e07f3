package daphnis.analysis.streamline

import daphnis.core.orbit.OrbitalFrequencies
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * The effect of a moon on a ring which it passes at the distance [distance], in lengths of the patch (Julian & Toomre
 * 1966, ApJ 146, 810; Showalter, Cuzzi, Marouf & Esposito 1986, Icarus 66, 297): marks for streamline pictures.
 *
 * @param massRatio μ, mass of the moon over that of the planet
 * @param distance from the moon's guiding centre to the ring, radially outward
 * @param semiMajorAxis a with a³ = GM/Ω² of the [frequencies], same unit of length
 * @param moonE amplitude of the moon's epicycle, a length: its eccentricity times its semi-major axis
 * @param frequencies of orbits there; their shear and κ count, the unit of time does not
 */
public class Encounter @JvmOverloads constructor(
    public val distance: Double,
    public val massRatio: Double,
    public val semiMajorAxis: Double,
    public val moonE: Double = 0.0,
    private val frequencies: OrbitalFrequencies = OrbitalFrequencies(1.0),
) {
    /** Whether orbits are those around a point mass. */
    public val isKeplerian: Boolean get() = frequencies.radialFactor == 1.0

    /** s/κ: how far the shear carries a streamline, over its distance, in a radian of its epicycle; 3/2 for Kepler. */
    private val drift get() = frequencies.shearFactor / frequencies.radialFactor

    init {
        require(distance != 0.0 && distance.isFinite()) { "distance from the moon is $distance; it must not be 0" }
        require(moonE >= 0 && moonE.isFinite()) { "the moon's epicycle is $moonE; it must be at least 0" }
    }

    /**
     * Wavelength of the wake along the orbit, 2π (s/κ) |Δa|: the distance by which the shear s carries the ring from the
     * moon in one epicycle. Around a point mass it is 3π|Δa|.
     */
    public val wavelength: Double get() = 2 * PI * drift * abs(distance)

    private val unit get() = massRatio * semiMajorAxis * semiMajorAxis * semiMajorAxis / (distance * distance)

    /**
     * Amplitude a·e that one passage leaves on a circular ring if the moon's orbit is a circle too; around a point mass
     * 2.2396 μ a³/Δa².
     */
    public val amplitude: Double get() = if (isKeplerian) IMPULSE * unit else impulse(0.0, 0.0)

    /** The least of [amplitudeAt] over the moon's places on its epicycle; NaN when that reaches the ring. */
    public val leastAmplitude: Double by lazy { places().minOf { amplitudeAt(it) } }

    /** The largest of [amplitudeAt]; NaN when the epicycle reaches the ring. */
    public val largestAmplitude: Double by lazy { places().maxOf { amplitudeAt(it) } }

    private fun places() = List(PLACES) { 2 * PI * it / PLACES }

    /**
     * Amplitude a·e that one passage leaves on a circular ring when the moon passes with the phase [phase] of its
     * epicycle, 0 at pericentre, at the time at which its guiding centre passes. It is the impulse to first order in
     * the mass: the force along the undisturbed paths,
     *
     * ```
     *   ∫ (2 (Ω/κ) f_y + i f_x) exp(−iκt) dt / κ,   ring − moon = (Δa + e cos φ, −s Δa t − 2 (Ω/κ) e sin φ),
     *   φ = phase + κt
     * ```
     *
     * which is [amplitude] for e = 0, to 3 parts in 10⁴. NaN if the epicycle reaches the ring, because the impulse is
     * not small then.
     */
    public fun amplitudeAt(phase: Double): Double {
        val e = moonE / abs(distance)
        return if (e >= 1) Double.NaN else impulse(e, phase)
    }

    /** The same for an epicycle [e] in units of Δa. */
    private fun impulse(e: Double, phase: Double): Double {
        // In units of Δa and 1/Ω.
        val kappa = frequencies.radialFactor
        val side = Math.signum(distance)
        var real = 0.0
        var imaginary = 0.0
        for (k in -STEPS..STEPS) {
            val t = k * STEP
            val swing = kappa * t
            val x = side + e * cos(phase + swing)
            val y = -frequencies.shearFactor * side * t - 2 / kappa * e * sin(phase + swing)
            val r2 = x * x + y * y
            val f = -STEP / (r2 * sqrt(r2))
            // (2 f_y/κ + i f_x) (cos κt − i sin κt).
            real += f * (2 / kappa * y * cos(swing) + x * sin(swing))
            imaginary += f * (x * cos(swing) - 2 / kappa * y * sin(swing))
        }
        return unit * sqrt(real * real + imaginary * imaginary) / kappa
    }

    /**
     * Distance along the orbit after which streamlines of the given [amplitude] a·e cross if nothing damps them:
     * (s/κ) Δa²/(a e), 3Δa²/(2 a e) around a point mass.
     */
    public fun crossing(amplitude: Double): Double = drift * distance * distance / amplitude

    /** Time between two passages, in orbits: the circumference over the distance drifted in one orbit. */
    public val synodicOrbits: Double get() = semiMajorAxis / (frequencies.shearFactor * abs(distance))

    /**
     * Distances from the moon, between [from] and [to], of the resonances (m+1):m, near the ring edge spaced by (2/3)
     * a/m²: where κ is m times the difference of the angular speeds if the ring is outside the moon, and m + 1 times if
     * it is inside. Angular speeds fall as a^(−s/Ω), with κ/Ω of the frame.
     */
    public fun resonances(from: Double, to: Double): List<Resonance> {
        val result = ArrayList<Resonance>()
        val kappa = frequencies.radialFactor
        val power = 1 / frequencies.shearFactor
        val nearest = minOf(abs(from), abs(to))
        if (nearest == 0.0) return result
        val side = if (distance > 0) 1 else -1
        var m = maxOf(1, (kappa * power * semiMajorAxis / maxOf(abs(from), abs(to))).toInt() - 1)
        while (true) {
            // Angular speed of the moon over that of the ring; (m+1)/m or m/(m+1) for Kepler.
            val speeds = if (side > 0) 1 + kappa / m else 1 - kappa / (m + 1)
            val offset = semiMajorAxis * (Math.pow(speeds, power) - 1)
            if (abs(offset) < nearest || result.size >= MOST_RESONANCES) return result
            if (offset in minOf(from, to)..maxOf(from, to)) result += Resonance(m, offset)
            m++
        }
    }

    /** The resonance ([m]+1):[m], [offset] from the moon's orbit. */
    public class Resonance(public val m: Int, public val offset: Double)

    private companion object {
        /** (8/9)·(2 K₀(2/3) + K₁(2/3)). */
        const val IMPULSE = 2.2396
        const val MOST_RESONANCES = 1000
        const val PLACES = 48

        // Far enough for the force to be a thousandth, fine enough for the nearest approach.
        const val STEPS = 6000
        const val STEP = 0.01
    }
}
