package daphnis.core.merging

/**
 * Which impacts break spheres, and into what. Each of the two breaks, unless its pieces would be too small. The energy of
 * the impact pays for the motion of the pieces: where ½ μ v_n² is less than they need, nothing breaks.
 *
 * Pieces are equal, of the density of the sphere, whose mass, centre of mass and momentum they have together. They come at
 * the end of the step, inside the sphere, in opposite pairs and one in the middle if they are odd, and fly apart from its
 * centre. So until they have left one another they overlap, and nobody else is overlapped.
 *
 * Immutable.
 *
 * @property speed v_n above which spheres break, the normal component of their relative velocity, ≥ 0
 * @property pieces of a sphere, 2 to [MOST_PIECES]
 * @property spread speed at which pieces leave the centre of their sphere, > 0
 * @property smallest radius that a piece may have, > 0
 * @property seed with the id and the step decides where pieces fly
 * @throws IllegalArgumentException for numbers that are out of range
 */
public class BreakRule @JvmOverloads constructor(
    public val speed: Double,
    public val pieces: Int,
    public val spread: Double,
    public val smallest: Double,
    public val seed: Long = 0,
) {
    init {
        require(speed >= 0 && speed.isFinite()) { "spheres break above the speed $speed; it must be ≥ 0" }
        require(pieces in 2..MOST_PIECES) { "spheres break into $pieces; it must be 2 to $MOST_PIECES" }
        require(spread > 0 && spread.isFinite()) { "pieces fly apart at a speed of $spread; it must be > 0" }
        require(smallest > 0 && smallest.isFinite()) { "the smallest piece has a radius of $smallest; it must be > 0" }
    }

    /** Radius of a piece over that of its sphere. */
    internal val ratio = 1 / StrictMath.cbrt(pieces.toDouble())

    /** Share of the mass that moves away from the centre. */
    private val moving = (pieces - pieces % 2).toDouble() / pieces

    /** Whether a sphere of [radius] has pieces that are large enough. */
    public fun canBreak(radius: Double): Boolean = radius * ratio >= smallest

    /** Energy of the motion of the pieces of a sphere of [mass] about its centre. */
    public fun energy(mass: Double): Double = 0.5 * mass * moving * spread * spread

    public companion object {
        /** Pieces that one sphere may have. */
        public const val MOST_PIECES: Int = 1000
    }
}
