package daphnis.core.cluster.bricks

import daphnis.core.cluster.bricks.Cuts.Companion.AXES

/**
 * How wide the halo of each brick is in one attempt at a step. A sphere of radius r belongs to the halo of a brick when
 * its distance from the territory is at most `2 bound + edge + extra + room + r` along every axis that is cut. Immutable.
 *
 * The first two terms and r are the **sight** of the brick: within the step no sphere goes farther than its bound, so
 * no sphere of the territory can touch one from beyond. `edge` stands for the radius of the spheres of the territory;
 * see [Bodies.edges]. `extra` is room for what may reach a sphere in sight by a chain of collisions, an estimate.
 *
 * @param bound how far a sphere may go along x, y, z, as far as is known
 * @param room along x, y, z for the rounding of positions, and for images that come nearer
 * @param edge by brick
 * @param extra by brick
 */
internal class HaloWidths(
    private val bound: DoubleArray,
    private val room: DoubleArray,
    private val edge: DoubleArray,
    private val extra: DoubleArray,
) {
    /** Of all bricks the largest. */
    private val widest: Double = edge.indices.maxOf { edge[it] + extra[it] }

    fun extra(brick: Int): Double = extra[brick]

    /** Width along [axis] for [brick] and points. */
    fun width(axis: Int, brick: Int): Double = (2 * bound[axis] + edge[brick] + extra[brick]) * ROOM + room[axis]

    /** The largest [width] along [axis]. */
    fun widest(axis: Int): Double = (2 * bound[axis] + widest) * ROOM + room[axis]

    /**
     * How far from the territory of [brick], along [axis], a point sphere can be and be touched, when the spheres of
     * the brick go at most [own] and others at most [other].
     */
    fun sight(axis: Int, brick: Int, own: Double, other: Double): Double =
        (own + other + edge[brick]) * ROOM + room[axis]

    /** Wider halos for the bricks that [isWrong] accepts, with larger bounds for all, for what follows [attempt]. */
    fun widened(isWrong: BooleanArray, reach: DoubleArray, attempt: Int, margins: HaloMargins): HaloWidths {
        val wider = DoubleArray(extra.size) { if (isWrong[it]) margins.widened(extra[it], attempt) else extra[it] }
        return HaloWidths(DoubleArray(AXES) { maxOf(bound[it], reach[it]) }, room, edge, wider)
    }

    /** Whether each brick computes all spheres. */
    val isEverything: Boolean get() = widest == Double.POSITIVE_INFINITY

    /** With these, every brick computes all spheres: what each finds is what the serial engine finds. */
    fun everything(): HaloWidths = HaloWidths(bound, room, edge, DoubleArray(extra.size) { Double.POSITIVE_INFINITY })

    companion object {
        /** No halo at all, of [bricks] bricks. */
        fun none(bricks: Int): HaloWidths =
            HaloWidths(DoubleArray(AXES), DoubleArray(AXES), DoubleArray(bricks), DoubleArray(bricks))

        /** Room for the rounding of distances. */
        private const val ROOM = 1 + 1e-9
    }
}
