package daphnis.analysis.streamline

import kotlin.math.PI
import kotlin.math.abs

/**
 * What a moon does to a ring it passes at the distance [distance], in lengths of the patch (Julian & Toomre 1966, ApJ 146, 810; Showalter, Cuzzi, Marouf & Esposito
 * 1986, Icarus 66, 297): marks for streamline pictures.
 *
 * @param massRatio μ, mass of the moon over that of the planet
 * @param semiMajorAxis of the moon, same unit of length
 */
public class Encounter(public val distance: Double, public val massRatio: Double, public val semiMajorAxis: Double) {
    init {
        require(distance != 0.0 && distance.isFinite()) { "distance from the moon is $distance; it must not be 0" }
    }

    /** Wavelength of the wake along the orbit, 3π|Δa|: the way that the ring drifts from the moon in one orbit. */
    public val wavelength: Double get() = 3 * PI * abs(distance)

    /** Amplitude a·e that one passage leaves, 2.2396 μ a³/Δa². */
    public val amplitude: Double get() = IMPULSE * massRatio * semiMajorAxis * semiMajorAxis * semiMajorAxis / (distance * distance)

    /** Distance along the orbit after which streamlines cross if nothing damps them: 3Δa²/(2 a e). */
    public val crossing: Double get() = 1.5 * distance * distance / amplitude

    /** Time between two passages, in orbits: the circumference over the way drifted in one. */
    public val synodicOrbits: Double get() = 2 * PI * semiMajorAxis / wavelength

    /** Distances from the moon, between [from] and [to], of the resonances (m+1):m, near the ring edge spaced by (2/3) a/m². */
    public fun resonances(from: Double, to: Double): List<Resonance> {
        val result = ArrayList<Resonance>()
        val nearest = minOf(abs(from), abs(to))
        if (nearest == 0.0) return result
        val side = if (distance > 0) 1 else -1
        var m = maxOf(1, (2 * semiMajorAxis / (3 * maxOf(abs(from), abs(to)))).toInt() - 1)
        while (true) {
            // Kepler: a ratio of (m+1)/m in frequency is ((m+1)/m)^(2/3) in distance.
            val ratio = Math.pow((m + 1.0) / m, 2.0 / 3.0)
            val offset = if (side > 0) semiMajorAxis * (ratio - 1) else semiMajorAxis * (1 / ratio - 1)
            if (abs(offset) < nearest || result.size >= MOST_RESONANCES) return result
            if (offset in minOf(from, to)..maxOf(from, to)) result += Resonance(m, offset)
            m++
        }
    }

    /** The resonance ([m]+1):[m], [offset] from the moon's orbit. */
    public class Resonance(public val m: Int, public val offset: Double)

    private companion object {
        /** (4/9)·(2 K₀(2/3) + K₁(2/3)). */
        const val IMPULSE = 2.2396
        const val MOST_RESONANCES = 1000
    }
}
