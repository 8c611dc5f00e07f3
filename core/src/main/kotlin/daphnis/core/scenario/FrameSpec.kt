package daphnis.core.scenario

import daphnis.core.input.Described
import daphnis.core.input.Planet
import daphnis.core.input.UnitsSpec
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.Locale

/**
 * Zonal harmonics of a planet.
 *
 * @property radiusInKm to which they refer
 */
@Serializable
public class OblatenessSpec @JvmOverloads constructor(
    @Described("radius of the planet to which the moments refer")
    public val radiusInKm: Double,
    @Described("J2 of the planet; default 0")
    public val j2: Double = 0.0,
    @Described("J4 of the planet; default 0")
    public val j4: Double = 0.0,
    @Described("J6 of the planet; default 0")
    public val j6: Double = 0.0,
)

/** Axes that turn. */
@Serializable
public sealed interface FrameSpec {
    /** ν/Ω, where it is said; else null. */
    public val verticalFactor: Double?

    /** Where the frame is, for a reader; null where that is not known. */
    public val inWords: String?

    /**
     * Frequencies of orbits in the frame, in radians per unit of time.
     *
     * @throws daphnis.core.input.InputException when the frame is not determined
     */
    public fun frequencies(units: UnitsSpec, check: ValueCheck): OrbitalFrequencies

    /** GM of the planet in length³/time² of [units]; null when the length is not known. */
    public fun gravitationalParameter(units: UnitsSpec): Double?

    /**
     * Distance of the middle of the frame from the centre of the planet, in units of length; null when that unit is not
     * known. Where the frame is given by its angular speed, Kepler's.
     *
     * @param frequencies as [frequencies] gives them
     */
    public fun distance(units: UnitsSpec, frequencies: OrbitalFrequencies): Double?

    /**
     * Hill's frame: exactly one of [angularSpeed], in radians per unit of time, and [distanceInKm] from the centre of
     * [planet].
     *
     * @property verticalFactor ν/Ω; when left out, 1 or what [oblateness] makes it
     * @property radialFactor κ/Ω; when left out, 1 or what [oblateness] makes it
     * @property gravitationalParameter GM in km³/s² in place of that of [planet]
     * @property oblateness of the planet, with [distanceInKm]; a point mass when left out
     */
    @Serializable
    @SerialName("hill")
    @Described("Hill's frame")
    public class Hill @JvmOverloads constructor(
        @Described("Ω in radians per unit of time; of this and `distanceInKm` exactly one")
        public val angularSpeed: Double? = null,
        @Described("distance from the centre of `planet` in km")
        public val distanceInKm: Double? = null,
        @Described("`saturn`, `jupiter`, `uranus` or `neptune`; default `saturn`")
        public val planet: Planet = Planet.SATURN,
        @Described("ν, the vertical frequency, over Ω; default 1, or by `oblateness`")
        override val verticalFactor: Double? = null,
        @Described("κ, the radial frequency of epicycles, over Ω; > 0, < 2; default 1, or by `oblateness`")
        public val radialFactor: Double? = null,
        @Described("GM in km³/s², in place of that of `planet`; default that of `planet`")
        public val gravitationalParameter: Double? = null,
        @Described("figure of the planet, with `distanceInKm`; default a point mass")
        public val oblateness: OblatenessSpec? = null,
    ) : FrameSpec {
        override val inWords: String?
            get() = distanceInKm?.let {
                val of = if (gravitationalParameter == null) planet.name.lowercase() else "the planet"
                "%.0f km from %s".format(Locale.ROOT, it, of)
            }

        /** GM of the planet in m³/s². */
        private val inSi: Double
            get() = gravitationalParameter?.let { it * METRES_PER_KM * METRES_PER_KM * METRES_PER_KM }
                ?: planet.gravitationalParameter

        override fun gravitationalParameter(units: UnitsSpec): Double? {
            val length = units.lengthInMetres ?: return null
            val time = units.timeInSeconds ?: return null
            return inSi * time * time / (length * length * length)
        }

        override fun distance(units: UnitsSpec, frequencies: OrbitalFrequencies): Double? {
            val metres = units.lengthInMetres ?: return null
            distanceInKm?.let { return it * METRES_PER_KM / metres }
            val planet = gravitationalParameter(units) ?: return null
            return StrictMath.cbrt(planet / (frequencies.omega * frequencies.omega))
        }

        override fun frequencies(units: UnitsSpec, check: ValueCheck): OrbitalFrequencies {
            check.must("frame", (angularSpeed == null) != (distanceInKm == null)) {
                "needs exactly one of angularSpeed and distanceInKm"
            }
            verticalFactor?.let { check.atLeast0("frame.verticalFactor", it) }
            radialFactor?.let { check.that("frame.radialFactor", it, it > 0 && it < 2) { "must be > 0 and < 2" } }
            val around = if (angularSpeed == null) around(distanceInKm!!, units, check) else given(angularSpeed, check)
            return OrbitalFrequencies(
                around.omega,
                radialFactor ?: around.radialFactor,
                verticalFactor ?: around.verticalFactor,
            )
        }

        private fun given(speed: Double, check: ValueCheck): OrbitalFrequencies {
            check.positive("frame.angularSpeed", speed)
            check.must("frame.oblateness", oblateness == null) { NEEDS_DISTANCE }
            gravitationalParameter?.let { check.positive("frame.gravitationalParameter", it) }
            return OrbitalFrequencies(speed)
        }

        private fun around(distance: Double, units: UnitsSpec, check: ValueCheck): OrbitalFrequencies {
            check.positive("frame.distanceInKm", distance)
            units.lengthInMetres?.let { check.positive("units.lengthInMetres", it) }
            check.positive("units.speedInCmPerSecond", units.speedInCmPerSecond)
            gravitationalParameter?.let { check.positive("frame.gravitationalParameter", it) }
            val second =
                units.timeInSeconds
                    ?: check.fail("units.lengthInMetres", "is missing; frame.distanceInKm needs it")
            val metres = distance * METRES_PER_KM
            val oblate = oblateness
            if (oblate != null) {
                check.must("frame.radialFactor", radialFactor == null) {
                    "follows from frame.oblateness; give one of the two"
                }
                check.positive("frame.oblateness.radiusInKm", oblate.radiusInKm)
                check.that("frame.distanceInKm", distance, distance >= oblate.radiusInKm) {
                    "is inside the planet, whose radius is ${oblate.radiusInKm} km"
                }
            }
            val inSeconds = try {
                if (oblate == null) {
                    OrbitalFrequencies.around(inSi, metres)
                } else {
                    val radius = oblate.radiusInKm * METRES_PER_KM
                    OrbitalFrequencies.around(
                        inSi,
                        metres,
                        radius,
                        oblate.j2,
                        oblate.j4,
                        oblate.j6,
                    )
                }
            } catch (e: IllegalArgumentException) {
                check.fail(if (oblate == null) "frame.distanceInKm" else "frame.oblateness", "cannot be: ${e.message}")
            }
            val speed = inSeconds.omega * second
            check.that("frame.distanceInKm", distance, speed > 0 && speed.isFinite()) {
                "gives an angular speed of $speed in the scenario's units; it must be > 0 and finite"
            }
            return OrbitalFrequencies(speed, inSeconds.radialFactor, inSeconds.verticalFactor)
        }
    }
}

private const val METRES_PER_KM = 1000.0
private const val NEEDS_DISTANCE = "is that of a planet; it needs frame.distanceInKm"
