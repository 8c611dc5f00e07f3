package daphnis.core.force

import daphnis.core.population.ExactSum

/** What each sphere, by index, gives to one body, mass · length/time: threads write it, one sums it. */
internal class Pulls {
    private var pull = Array(3) { DoubleArray(0) }

    /** Makes room for [size] spheres. */
    fun prepare(size: Int) {
        if (pull[0].size < size) pull = Array(3) { DoubleArray(size) }
    }

    /** The spheres [from] until [to] give nothing, unless [put] says else. */
    fun clear(from: Int, to: Int) {
        for (component in pull) component.fill(0.0, from, to)
    }

    /** Sphere [k] gives [strength] times ([dx], [dy], [dz]). */
    fun put(k: Int, strength: Double, dx: Double, dy: Double, dz: Double) {
        pull[0][k] = strength * dx
        pull[1][k] = strength * dy
        pull[2][k] = strength * dz
    }

    /** Makes the three of [sums] from index [first] on those over [size] spheres. */
    fun sum(size: Int, sums: Array<ExactSum>, first: Int = 0) {
        for (axis in 0..2) {
            sums[first + axis].clear()
            sums[first + axis].addAll(pull[axis], 0, size)
        }
    }
}
