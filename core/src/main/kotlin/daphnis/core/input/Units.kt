package daphnis.core.input

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/**
 * The units of a scenario in SI units.
 *
 * @property speedInCmPerSecond how many cm/s one unit of speed is; restitution laws are measured in cm/s
 * @property lengthInMetres how many metres one unit of length is; needed for planets and gravity, whose constants are
 *   known in SI units
 * @property massInKg how many kilograms one unit of mass is
 */
@Serializable
public class UnitsSpec @JvmOverloads constructor(
    @Described("one unit of speed in cm/s, for laws of restitution, which were measured in cm/s; default 1")
    public val speedInCmPerSecond: Double = 1.0,
    @Described("one unit of length in metres; planets and gravity need it; default none")
    public val lengthInMetres: Double? = null,
    @Described("one unit of mass in kilograms; default 1")
    public val massInKg: Double = 1.0,
) {
    /** How many seconds one unit of time is; null when the length is not known. */
    public val timeInSeconds: Double? get() = lengthInMetres?.let { it * CM_PER_METRE / speedInCmPerSecond }

    /** Newton's constant in length³/(mass · time²); null when the length is not known. CODATA 2018. */
    public val gravitationalConstant: Double?
        get() {
            val length = lengthInMetres ?: return null
            val time = timeInSeconds ?: return null
            return GRAVITATIONAL_CONSTANT * massInKg * time * time / (length * length * length)
        }

    /** The units in SI units; null when the length is not known. */
    public val si: SiUnits? get() = lengthInMetres?.let { SiUnits(it, timeInSeconds!!, massInKg) }

    public companion object {
        /** m³ kg⁻¹ s⁻², CODATA 2018. */
        public const val GRAVITATIONAL_CONSTANT: Double = 6.67430e-11
        private const val CM_PER_METRE = 100.0
    }
}

/**
 * Planets with rings.
 *
 * @property gravitationalParameter GM in m³/s² (Jacobson and others, JPL; to the digits that matter here)
 */
@Serializable
public enum class Planet(public val gravitationalParameter: Double) {
    @SerialName("saturn")
    SATURN(3.7931206e16),

    @SerialName("jupiter")
    JUPITER(1.26686532e17),

    @SerialName("uranus")
    URANUS(5.793951e15),

    @SerialName("neptune")
    NEPTUNE(6.835100e15),
}
