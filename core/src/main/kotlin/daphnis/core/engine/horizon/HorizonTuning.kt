package daphnis.core.engine.horizon

/**
 * How epochs are laid out. It affects only the time that steps take. Where that makes an epoch far more work than steps
 * of the serial engine are, there is none.
 *
 * @param steps steps of an epoch, at least 1
 * @param classBound a sphere faster than this, in units of the root mean square velocity along an axis, is a roamer
 * @param deviation how far a sphere may stray from its line, in units of the largest radius of a sphere with a cell
 * @param cellsAlong cells in the length that a pair can bridge, along a row
 * @param cellsAcross the same along the other two axes
 * @throws IllegalArgumentException when a number is out of range
 */
public class HorizonTuning internal constructor(
    internal val steps: Int,
    internal val classBound: Double,
    internal val deviation: Double,
    internal val cellsAlong: Double,
    internal val cellsAcross: Double,
    /** Into how many windows an epoch of one step is cut. */
    internal val windows: Int,
) {
    @JvmOverloads
    public constructor(
        steps: Int,
        classBound: Double = 3.0,
        deviation: Double = 0.06,
        cellsAlong: Double = 2.0,
        cellsAcross: Double = 1.0,
    ) : this(steps, classBound, deviation, cellsAlong, cellsAcross, 1)

    init {
        require(steps in 1..MOST_STEPS) { "$steps steps of an epoch; it must be 1 to $MOST_STEPS" }
        require(windows >= 1 && (windows == 1 || steps == 1)) { "$windows windows in $steps steps" }
        require(classBound > 0 && deviation >= 0 && cellsAlong > 0 && cellsAcross > 0) {
            "class bound $classBound, deviation $deviation, cells $cellsAlong and $cellsAcross; they must be positive"
        }
        // Squares of deviations have to be finite: no other sphere is near its line.
        require(deviation <= MOST_DEVIATION) { "deviation is $deviation; it must be at most $MOST_DEVIATION" }
    }

    /** The same in an epoch of one step, cut into so many [windows]. */
    internal fun inWindows(windows: Int): HorizonTuning =
        HorizonTuning(1, classBound, deviation, cellsAlong, cellsAcross, windows)

    /** The same with so many cells [along] rows and [across]. */
    internal fun inCells(along: Double, across: Double): HorizonTuning =
        HorizonTuning(steps, classBound, deviation, along, across, windows)

    internal companion object {
        const val MOST_STEPS = 64
        private const val MOST_DEVIATION = 1e3
    }
}
