package daphnis.core.source

import daphnis.core.initial.SeededRandom
import daphnis.core.initial.SizeDistribution
import daphnis.core.space.Space

/**
 * What the spheres are like that a source brings.
 *
 * @param sizes drawn for each; what it draws must not depend on what it has drawn before
 * @property largest the greatest radius that it draws
 * @param density mass per volume, unless [mass] is given
 * @param mass of each sphere; null where it follows from the density
 * @property material number of what they are made of, where spheres have materials
 */
public class Supply @JvmOverloads constructor(
    private val sizes: SizeDistribution,
    public val largest: Double,
    private val density: Double = 1.0,
    private val mass: Double? = null,
    public val material: Int = 0,
) {
    init {
        require(largest > 0 && largest.isFinite()) { "the largest radius is $largest; it must be > 0" }
        require(density > 0 && density.isFinite()) { "density is $density; it must be > 0" }
        require(mass == null || mass > 0 && mass.isFinite()) { "mass is $mass; it must be > 0" }
    }

    internal fun radius(random: SeededRandom): Double = sizes.draw(random)

    internal fun mass(radius: Double, space: Space): Double = mass ?: (density * space.volume(radius))
}

/** A sphere that comes: position, velocity and angular velocity by axis. */
internal class Newcomer(val radius: Double, val mass: Double, val material: Int) {
    val position = DoubleArray(AXES)
    val velocity = DoubleArray(AXES)
    val spin = DoubleArray(AXES)

    private companion object {
        const val AXES = 3
    }
}
