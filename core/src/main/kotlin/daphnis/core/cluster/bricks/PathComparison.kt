package daphnis.core.cluster.bricks

import daphnis.core.cluster.bricks.Cuts.Companion.AXES

/** Compares the paths of the halo, as brick [number] has computed them, with those that their owners have found. */
internal class PathComparison(private val number: Int, private val territory: Territory, private val brick: Brick) {
    private val spheres = brick.spheres
    private val places = IdIndex()
    private val bound = DoubleArray(AXES)
    private val sight = DoubleArray(AXES)

    /** To be called when the spheres of the brick are gathered. */
    fun index() {
        val near = spheres.near
        places.clear(near.size)
        for (k in 0 until near.size) places.put(spheres.id[near[k]], near[k])
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
            if (!isWide && spheres.here < total) return false
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
        for (k in 0 until spheres.near.size) if (isInSight(spheres.near[k])) count++
        return count
    }

    private fun isInSight(place: Int): Boolean {
        val r = spheres.radius[place]
        for (axis in 0 until AXES) {
            val d = territory.distance(axis, territory.part(axis, number), spheres.position(axis)[place])
            if (d > sight[axis] + r) return false
        }
        return true
    }
}
