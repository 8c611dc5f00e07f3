package daphnis.core.collision

import daphnis.core.population.Population

/**
 * The population during one step: a packed copy in cell order, eight doubles a sphere, so that the sphere a collision touches is
 * one or two cache lines and a cell is a run of memory. **Slot** s is the place of a sphere in this order and does not change
 * within the step; entry `s·8 + k` of [state] is
 *
 * | k | 0 1 2 | 3 4 5 | 6 | 7 |
 * |---|---|---|---|---|
 * | | x y z | vx vy vz | local time, from the start of the step | radius |
 *
 * A sphere's position and velocity are those at its **local time**; both change only at its own collisions. The population
 * itself is not written before [store], so it is the copy from which a step is redone.
 */
public class StepRows {
    /** See the table above. */
    public var state: DoubleArray = DoubleArray(0)
        private set

    /** Mass by slot. */
    public var mass: DoubleArray = DoubleArray(0)
        private set

    /** Stable id by slot. */
    public var id: IntArray = IntArray(0)
        private set

    /** Index in the population before the step, by slot. */
    public var origin: IntArray = IntArray(0)
        private set

    /** Time of the last collision by slot, counted from the start of this step (≤ 0 when it lies before); −∞ when there was none. */
    public var lastCollision: DoubleArray = DoubleArray(0)
        private set

    /** Number of spheres. */
    public var size: Int = 0
        private set

    private var tracksLastCollision = false

    /** Takes [population] over in the given [order] (index by slot), every local time 0. Allocates only when the population grew. */
    public fun load(population: Population, order: IntArray, tracksLastCollision: Boolean) {
        val n = population.size
        reserve(n)
        size = n
        this.tracksLastCollision = tracksLastCollision
        val state = state
        val x = population.x
        val y = population.y
        val z = population.z
        val vx = population.vx
        val vy = population.vy
        val vz = population.vz
        val r = population.radius
        var p = 0
        for (slot in 0 until n) {
            val k = order[slot]
            state[p] = x[k]
            state[p + 1] = y[k]
            state[p + 2] = z[k]
            state[p + VX] = vx[k]
            state[p + VX + 1] = vy[k]
            state[p + VX + 2] = vz[k]
            state[p + TIME] = 0.0
            state[p + RADIUS] = r[k]
            p += STRIDE
        }
        val m = population.mass
        val ids = population.id
        for (slot in 0 until n) {
            val k = order[slot]
            mass[slot] = m[k]
            id[slot] = ids[k]
            origin[slot] = k
        }
        if (tracksLastCollision) {
            val last = population.lastCollision
            for (slot in 0 until n) lastCollision[slot] = last[order[slot]]
        }
    }

    /** Brings every sphere to the end of a step of [duration] and writes all back: index k of [population] is slot k from now on. */
    public fun store(population: Population, duration: Double) {
        val state = state
        val n = size
        val x = population.x
        val y = population.y
        val z = population.z
        val vx = population.vx
        val vy = population.vy
        val vz = population.vz
        val r = population.radius
        var p = 0
        for (slot in 0 until n) {
            val rest = duration - state[p + TIME]
            val u = state[p + VX]
            val v = state[p + VX + 1]
            val w = state[p + VX + 2]
            x[slot] = state[p] + u * rest
            y[slot] = state[p + 1] + v * rest
            z[slot] = state[p + 2] + w * rest
            vx[slot] = u
            vy[slot] = v
            vz[slot] = w
            r[slot] = state[p + RADIUS]
            p += STRIDE
        }
        mass.copyInto(population.mass, 0, 0, n)
        id.copyInto(population.id, 0, 0, n)
        if (tracksLastCollision) {
            val last = population.lastCollision
            for (slot in 0 until n) last[slot] = lastCollision[slot] - duration
        }
        population.orderChanged()
    }

    private fun reserve(n: Int) {
        if (state.size >= n * STRIDE) return
        state = DoubleArray(n * STRIDE)
        mass = DoubleArray(n)
        id = IntArray(n)
        origin = IntArray(n)
        lastCollision = DoubleArray(n)
    }

    public companion object {
        /** Doubles a sphere in [state]. */
        public const val STRIDE: Int = 8

        /** Offset of the velocity in a row. */
        public const val VX: Int = 3

        /** Offset of the local time in a row. */
        public const val TIME: Int = 6

        /** Offset of the radius in a row. */
        public const val RADIUS: Int = 7
    }
}
