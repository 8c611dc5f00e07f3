package daphnis.analysis.movie

/**
 * How a movie is drawn.
 *
 * @property framesPerSecond in [[LEAST_RATE], [MOST_RATE]]
 * @property width of the frames in pixels, in [[LEAST_WIDTH], [MOST_WIDTH]]
 * @throws IllegalArgumentException for a number outside its range
 */
public class MovieOptions @JvmOverloads constructor(
    public val view: MovieView = MovieView.TOP,
    public val colour: MovieColour = MovieColour.SPEED,
    public val framesPerSecond: Double = 25.0,
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

        /** Narrower ones have no room for the legend. */
        public const val LEAST_WIDTH: Int = 240
        public const val MOST_WIDTH: Int = 4096
    }
}

/**
 * From where a movie looks; y is to the right in both views.
 *
 * @property word for it on the command line
 * @property up the axis that points up in the picture
 * @property towards the axis that points to the viewer
 */
public enum class MovieView(public val word: String, internal val up: Int, internal val towards: Int) {
    /** From above: x upward. */
    TOP("top", 0, 2),

    /** From the side, along x: z upward. */
    SIDE("side", 2, 0),
}

/**
 * What the colour of a sphere means.
 *
 * @property word for it on the command line
 */
public enum class MovieColour(public val word: String) {
    /** Speed against the mean flow that the boundary drives. */
    SPEED("speed"),

    /** Radius. */
    SIZE("size"),

    /** The coordinate z. */
    HEIGHT("height"),

    /** Mass per area of the picture around the sphere. */
    DENSITY("density"),
}
