package daphnis.core.cluster.bricks

/**
 * Into how many parts space is cut along x, y and z: slabs along one axis, pencils along two, blocks along three. An
 * axis along which images slide, or along which all spheres are at one place, is not cut, whatever is asked for.
 *
 * @throws IllegalArgumentException unless each is at least 1 and there are at most [MOST_BRICKS] bricks
 */
internal data class BrickDivision(val x: Int, val y: Int, val z: Int) {
    init {
        for (parts in listOf(x, y, z)) {
            require(parts >= 1) { "$parts parts along an axis" }
        }
        require(x * y * z <= MOST_BRICKS) { "${x * y * z} bricks, one for each thread; $MOST_BRICKS are possible" }
    }

    /** Number of bricks. */
    val bricks: Int get() = x * y * z

    fun along(axis: Int): Int = when (axis) {
        0 -> x
        1 -> y
        else -> z
    }

    companion object {
        /** The most bricks: each writes to each. */
        const val MOST_BRICKS: Int = 1024
    }
}
