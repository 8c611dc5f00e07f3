package daphnis.core.engine.bricks

import daphnis.core.engine.bricks.Cuts.Companion.AXES

/** Compares the paths of the halo, as brick [number] has computed them, with those that their owners have found. */
internal class PathComparison(private val number: Int, private val territory: Territory, private val brick: Brick) {
    private val places = IdIndex()
    private val bound = DoubleArray(AXES)
    private val sight = DoubleArray(AXES)

    /** To be called when the columns of the brick are filled. */
    fun index() {
        val columns = brick.columns
        places.clear(columns.size - brick.own)
        for (k in brick.own until columns.size) places.put(columns.id[k], k)
    }

    /**
     * Whether every sphere in sight was in the halo and has the path there that its owner has found.
     *
     * @param widths of the halo
     * @param outcomes of all other bricks
     * @param total number of all spheres; a halo that holds all the others needs no width
     */
    fun isRight(widths: HaloWidths, outcomes: Array<Outcome?>, total: Int): Boolean {
        brick.bound.copyInto(bound)
        for (outcome in outcomes) {
            if (outcome != null) for (axis in 0 until AXES) bound[axis] = maxOf(bound[axis], outcome.bound[axis])
        }
        for (axis in 0 until AXES) {
            sight[axis] = widths.sight(axis, number, brick.bound[axis], bound[axis])
            val isWide = !territory.cuts.isCut(axis) || widths.width(axis, number) >= sight[axis]
            if (!isWide && brick.columns.size < total) return false
        }
        var known = 0
        for (outcome in outcomes) {
            if (outcome == null) continue
            for (k in 0 until outcome.paths.size) {
                val place = places.find(outcome.paths.id(k))
                // A wider halo than this one's has more; those are out of sight.
                if (place < 0 || !isInSight(place)) continue
                if (brick.wholePath(place) != outcome.paths.hash(k)) return false
                known++
            }
        }
        return known == countInSight()
    }

    private fun countInSight(): Int {
        var count = 0
        for (place in brick.own until brick.columns.size) if (isInSight(place)) count++
        return count
    }

    private fun isInSight(place: Int): Boolean {
        val r = brick.columns.radius[place]
        for (axis in 0 until AXES) {
            val d = territory.distance(axis, territory.part(axis, number), brick.columns.position(axis)[place])
            if (d > sight[axis] + r) return false
        }
        return true
    }
}
