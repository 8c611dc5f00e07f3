package daphnis.core.initial

/** Draws the velocity of one sphere into `into[0..2]`. */
public fun interface VelocityField {
    public fun draw(random: SeededRandom, into: DoubleArray)
}

/** Every component uniform in ±[halfWidth]. */
public class UniformVelocities(public val halfWidth: Double) : VelocityField {
    init {
        require(halfWidth >= 0 && halfWidth.isFinite()) { "half width is $halfWidth; it must be at least 0" }
    }

    override fun draw(random: SeededRandom, into: DoubleArray) {
        for (axis in 0..2) into[axis] = random.nextDouble(-halfWidth, halfWidth)
    }
}

/** Maxwellian: every component normal with standard deviation [sigma]. */
public class GaussianVelocities(public val sigma: Double) : VelocityField {
    init {
        require(sigma >= 0 && sigma.isFinite()) { "sigma is $sigma; it must be at least 0" }
    }

    override fun draw(random: SeededRandom, into: DoubleArray) {
        for (axis in 0..2) into[axis] = sigma * random.nextGaussian()
    }
}
