package daphnis.core.engine.bricks

import daphnis.core.population.SphereColumns

/**
 * The spheres with which a brick computes, copied: its own first, those of its halo behind them, as they were at the
 * start of the step. The arrays keep their size from step to step.
 */
internal class BrickColumns : SphereColumns {
    override var size = 0
        private set
    override var x = DoubleArray(0)
        private set
    override var y = DoubleArray(0)
        private set
    override var z = DoubleArray(0)
        private set
    override var vx = DoubleArray(0)
        private set
    override var vy = DoubleArray(0)
        private set
    override var vz = DoubleArray(0)
        private set
    override var radius = DoubleArray(0)
        private set
    override var mass = DoubleArray(0)
        private set
    override var lastCollision = DoubleArray(0)
        private set
    override var id = IntArray(0)
        private set

    /** Removes all spheres and makes room for [count]. */
    fun clear(count: Int) {
        size = 0
        if (id.size >= count) return
        val n = count + count / SPARE
        x = DoubleArray(n)
        y = DoubleArray(n)
        z = DoubleArray(n)
        vx = DoubleArray(n)
        vy = DoubleArray(n)
        vz = DoubleArray(n)
        radius = DoubleArray(n)
        mass = DoubleArray(n)
        lastCollision = DoubleArray(n)
        // Assigned last, since its length says how many spheres there is room for: an allocation before it may have
        // failed.
        id = IntArray(n)
    }

    /** Appends the entries [indices] of [spheres], for which there is room. */
    fun add(spheres: SphereColumns, indices: IndexList) {
        copy(spheres.x, x, indices)
        copy(spheres.y, y, indices)
        copy(spheres.z, z, indices)
        copy(spheres.vx, vx, indices)
        copy(spheres.vy, vy, indices)
        copy(spheres.vz, vz, indices)
        copy(spheres.radius, radius, indices)
        copy(spheres.mass, mass, indices)
        copy(spheres.lastCollision, lastCollision, indices)
        for (k in 0 until indices.size) id[size + k] = spheres.id[indices[k]]
        size += indices.size
    }

    private fun copy(from: DoubleArray, to: DoubleArray, indices: IndexList) {
        val at = size
        for (k in 0 until indices.size) to[at + k] = from[indices[k]]
    }

    private companion object {
        /** One part in so many is room for more. */
        const val SPARE = 4
    }
}
