package daphnis.core.cluster.bricks

/**
 * Into how many parts space is cut along x, y and z: slabs along one axis, pencils along two, blocks along three. An
 * axis along which images slide, or along which all spheres are at one place, is not cut, whatever is asked for.
 *
 * @throws IllegalArgumentException unless each is in 1..[MOST] and there are at most [MOST_BRICKS] bricks
 */
internal data class BrickDivision(val x: Int, val y: Int, val z: Int) {
    init {
        for (parts in listOf(x, y, z)) {
            require(parts in 1..MOST) { "$parts parts along an axis; 1 to $MOST are possible" }
        }
        require(x * y * z <= MOST_BRICKS) { "${x * y * z} bricks; $MOST_BRICKS are possible" }
    }

    /** Number of bricks. */
    val bricks: Int get() = x * y * z

    fun along(axis: Int): Int = when (axis) {
        0 -> x
        1 -> y
        else -> z
    }

    companion object {
        /** The most parts along one axis. */
        const val MOST: Int = 32

        /** The most bricks: each writes to each. */
        const val MOST_BRICKS: Int = 256
    }
}
