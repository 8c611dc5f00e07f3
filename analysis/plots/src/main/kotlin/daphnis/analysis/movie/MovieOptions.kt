package daphnis.analysis.movie

import kotlin.math.floor

/**
 * How a movie is drawn.
 *
 * @property framesPerSecond in [[LEAST_RATE], [MOST_RATE]]; [rateFor] gives one that suits the number of frames
 * @property width of the frames in pixels, in [[LEAST_WIDTH], [MOST_WIDTH]]
 * @throws IllegalArgumentException for a number outside its range
 */
public class MovieOptions @JvmOverloads constructor(
    public val view: MovieView = MovieView.TOP,
    public val colour: MovieColour = MovieColour.SPEED,
    public val framesPerSecond: Double = USUAL_RATE,
    public val width: Int = 1200,
) {
    init {
        require(framesPerSecond in LEAST_RATE..MOST_RATE) {
            "frames per second are $framesPerSecond; they must be in $LEAST_RATE..$MOST_RATE"
        }
        require(width in LEAST_WIDTH..MOST_WIDTH) { "width is $width; it must be in $LEAST_WIDTH..$MOST_WIDTH pixels" }
    }

    public companion object {
        public const val LEAST_RATE: Double = 0.1
        public const val MOST_RATE: Double = 100.0

        /** Frames per second where there are many. */
        public const val USUAL_RATE: Double = 25.0

        /** A movie should last as many seconds, if its frames then do not stand for longer than one. */
        private const val LEAST_SECONDS = 4.0

        /** Whole frames per second at which [frames] last at least four seconds, from 1 to [USUAL_RATE]. */
        @JvmStatic
        public fun rateFor(frames: Int): Double = floor(frames / LEAST_SECONDS).coerceIn(1.0, USUAL_RATE)

        /** Narrower ones have no room for the legend. */
        public const val LEAST_WIDTH: Int = 240
        public const val MOST_WIDTH: Int = 4096
    }
}

/**
 * From where a movie looks; y is to the right in both views, as in the pictures of a report, but x of what is more than
 * four times as long along x as along y. The side that is nearest in the view from the side is the lower edge of the
 * view from above.
 *
 * @property word for it on the command line
 */
public enum class MovieView(public val word: String) {
    /** From above: x upward, or y where x is to the right. */
    TOP("top"),

    /** From the side, along x, or y where x is to the right: z upward. */
    SIDE("side"),
}

/**
 * What the colour of a sphere means.
 *
 * @property word for it on the command line
 */
public enum class MovieColour(public val word: String) {
    /** Speed against the mean flow that the boundary drives. */
    SPEED("speed"),

    /** How fast a sphere spins, |ω|; relative to the frame in Hill's frame. Of rough spheres. */
    SPIN("spin"),

    /** Radius. */
    SIZE("size"),

    /** The coordinate z. */
    HEIGHT("height"),

    /** What it is made of. Of spheres with materials. */
    MATERIAL("material"),

    /** Mass per area of the picture around the sphere. */
    DENSITY("density"),
}
