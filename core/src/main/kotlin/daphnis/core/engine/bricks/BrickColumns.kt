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
    fun add(spheres: SphereColumns, indices: IndexRuns) {
        for (run in 0 until indices.runs) add(spheres, indices.from(run), indices.to(run))
    }

    private fun add(spheres: SphereColumns, from: Int, to: Int) {
        spheres.x.copyInto(x, size, from, to)
        spheres.y.copyInto(y, size, from, to)
        spheres.z.copyInto(z, size, from, to)
        spheres.vx.copyInto(vx, size, from, to)
        spheres.vy.copyInto(vy, size, from, to)
        spheres.vz.copyInto(vz, size, from, to)
        spheres.radius.copyInto(radius, size, from, to)
        spheres.mass.copyInto(mass, size, from, to)
        spheres.lastCollision.copyInto(lastCollision, size, from, to)
        spheres.id.copyInto(id, size, from, to)
        size += to - from
    }

    private companion object {
        /** One part in so many is room for more. */
        const val SPARE = 4
    }
}
