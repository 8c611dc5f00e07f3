package daphnis.analysis.diffusion

/** Lags of functions that are wanted over many powers of ten. */
internal object Lags {
    private const val GROWTH = 1.2

    /** Numbers of places from 1 up to half of [times], each a fifth more than the one before at least. */
    fun upToHalf(times: Int): IntArray = generateSequence(1) { maxOf(it + 1, (it * GROWTH).toInt()) }
        .takeWhile { it <= times / 2 }.toList().toIntArray()

    /** Mean lag over all origins of [count] times, [time] k being the k-th, between times [steps] places apart. */
    fun mean(count: Int, steps: Int, time: (Int) -> Double): Double =
        (0 until count - steps).sumOf { time(it + steps) - time(it) } / (count - steps)
}
