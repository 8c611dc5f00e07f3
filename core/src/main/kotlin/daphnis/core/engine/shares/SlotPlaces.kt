package daphnis.core.engine.shares

/** The place of the row of a sphere, by index in the columns of the step. Groups of different spheres can share one. */
internal class SlotPlaces {
    private var places = IntArray(0)

    /** Makes room for [spheres]. */
    fun reserve(spheres: Int) {
        if (places.size < spheres) places = IntArray(spheres) { NONE }
    }

    /** The place of [index]; [NONE] when it has no row. */
    fun of(index: Int): Int = places[index]

    fun put(index: Int, place: Int) {
        places[index] = place
    }

    /** [index], which may be one of a larger population before, has no row any more. */
    fun forget(index: Int) {
        if (index < places.size) places[index] = NONE
    }

    companion object {
        const val NONE = -1
    }
}
