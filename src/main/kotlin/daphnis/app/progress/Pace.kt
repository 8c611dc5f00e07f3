package daphnis.app.progress

/** How fast a run to time [until] goes, since this was made, and what time is left. */
internal class Pace(private val until: Double) {
    private val begin = System.nanoTime()
    private var firstTime = Double.NaN

    /** Of the clock on the wall, since this was made. */
    fun seconds(): Double = (System.nanoTime() - begin) * 1e-9

    /** Seconds that are left at [time] of the run; not finite the first time, when nothing is known. */
    fun left(time: Double): Double {
        if (firstTime.isNaN()) firstTime = time
        return seconds() * (until - time) / (time - firstTime)
    }
}
