package daphnis.core.hill

import daphnis.core.input.UnitsSpec
import daphnis.core.orbit.OrbitalFrequencies
import kotlin.math.abs

/**
 * A moon on an epicyclic orbit in Hill's frame, which a ring feels. Lengths are in units of
 * length.
 */
public interface Moon {
    /** Radial position of its guiding centre. */
    public val x: Double

    /** Amplitude of its epicycle: eccentricity times semi-major axis. */
    public val e: Double

    /** Amplitude of its vertical swing: inclination times semi-major axis. */
    public val inclination: Double

    /** Whether it comes back after each synodic period. */
    public val returns: Boolean

    /** Its epicycle at [epoch]; for all times, unless it feels the ring. */
    public val orbit: Epicycle

    /** A time. */
    public val epoch: Double

    /**
     * Its mass over that of the planet of [gravitationalParameter] GM, length³/time²; null where [units] do not tell.
     */
    public fun massRatio(units: UnitsSpec, gravitationalParameter: Double): Double?

    /**
     * Orbits between two passages by the middle of the frame, at so great a [distance] from the planet: the
     * circumference there, along which a moon that returns does so, over what the frame's shear carries it in an orbit.
     *
     * @param orbits in the frame
     * @return null where the moon stays in the middle
     */
    public fun orbitsBetweenPassages(distance: Double, orbits: OrbitalFrequencies): Double? =
        if (x == 0.0) null else distance / (orbits.shearFactor * abs(x))
}
