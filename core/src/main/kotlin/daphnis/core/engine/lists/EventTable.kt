package daphnis.core.engine.lists

/**
 * What is known of the next event of each sphere, by slot. Regions and the one that joins what they have done share it;
 * each writes what belongs to its own spheres.
 *
 * All that is known of a sphere lies side by side, since events come all over memory: eight longs, of which
 *
 * | 0 | 1 | 2 | 3 | 4 | 5 | 6 |
 * |---|---|---|---|---|---|---|
 * | time | others | what, partner's version | image, version | next, previous | place, settled | is out |
 *
 * are bits of a double, or two ints, the first in the lower half.
 */
internal class EventTable {
    private var table = LongArray(0)

    /** Makes room for [spheres], of which none has an event. */
    fun reserve(spheres: Int) {
        if (table.size < WIDTH * spheres) table = LongArray(WIDTH * spheres)
        table.fill(0, 0, WIDTH * spheres)
        for (k in 0 until spheres) setPlace(k, SphereCalendar.NONE)
    }

    private fun low(sphere: Int, k: Int): Int = table[WIDTH * sphere + k].toInt()

    private fun high(sphere: Int, k: Int): Int = (table[WIDTH * sphere + k] ushr Int.SIZE_BITS).toInt()

    private fun setLow(sphere: Int, k: Int, value: Int) {
        val p = WIDTH * sphere + k
        table[p] = (table[p] and HIGH) or (value.toLong() and LOW)
    }

    private fun setHigh(sphere: Int, k: Int, value: Int) {
        val p = WIDTH * sphere + k
        table[p] = (table[p] and LOW) or (value.toLong() shl Int.SIZE_BITS)
    }

    /** When the next event is, from the start of the step. */
    fun time(sphere: Int): Double = Double.fromBits(table[WIDTH * sphere])

    fun setTime(sphere: Int, time: Double) {
        table[WIDTH * sphere] = time.toRawBits()
    }

    /** No event other than that with the partner of the next one comes before this time. */
    fun others(sphere: Int): Double = Double.fromBits(table[WIDTH * sphere + OTHERS])

    fun setOthers(sphere: Int, time: Double) {
        table[WIDTH * sphere + OTHERS] = time.toRawBits()
    }

    /** What the event is, see [NextEvents]. */
    fun what(sphere: Int): Int = low(sphere, WHAT)

    fun setWhat(sphere: Int, what: Int) {
        setLow(sphere, WHAT, what)
    }

    /** The version that the partner's path had when the event was found, and its image. */
    fun partnersVersion(sphere: Int): Int = high(sphere, WHAT)

    fun image(sphere: Int): Int = low(sphere, IMAGE)

    fun setPartner(sphere: Int, version: Int, image: Int) {
        setHigh(sphere, WHAT, version)
        setLow(sphere, IMAGE, image)
    }

    fun version(sphere: Int): Int = high(sphere, IMAGE)

    /** The sphere has another path than before. */
    fun bend(sphere: Int) {
        setHigh(sphere, IMAGE, version(sphere) + 1)
    }

    /** The places of the sphere and its images have changed together, and nothing else: bounds stay, images do not. */
    fun wrap(sphere: Int) {
        bend(sphere)
        if (what(sphere) <= NextEvents.HINT) setWhat(sphere, NextEvents.BOUND)
    }

    /** The version that a path had when the window began, as other regions see it. */
    fun settled(sphere: Int): Int = high(sphere, PLACE)

    /** Everybody sees the path that the sphere has. */
    fun settle(sphere: Int) {
        setHigh(sphere, PLACE, version(sphere))
    }

    /** Where a sphere is in a [SphereCalendar]: which bucket, and the next and the previous one there. */
    fun place(sphere: Int): Int = low(sphere, PLACE)

    fun setPlace(sphere: Int, place: Int) {
        setLow(sphere, PLACE, place)
    }

    fun next(sphere: Int): Int = low(sphere, LINKS)

    fun setNext(sphere: Int, next: Int) {
        setLow(sphere, LINKS, next)
    }

    fun previous(sphere: Int): Int = high(sphere, LINKS)

    fun setPrevious(sphere: Int, previous: Int) {
        setHigh(sphere, LINKS, previous)
    }

    /** Whether a sphere has left its shell, and is to get a new list when the window ends. */
    fun isOut(sphere: Int): Boolean = table[WIDTH * sphere + OUT] != 0L

    fun setOut(sphere: Int, isOut: Boolean) {
        table[WIDTH * sphere + OUT] = if (isOut) 1 else 0
    }

    private companion object {
        const val WIDTH = 8
        const val OTHERS = 1
        const val WHAT = 2
        const val IMAGE = 3
        const val LINKS = 4
        const val PLACE = 5
        const val OUT = 6
        const val LOW = 0xffffffffL
        const val HIGH = LOW.inv()
    }
}
