package daphnis.core.force

import daphnis.core.growth.GrowingTable

/** Point masses that attract: positions and masses of the first [size] entries. */
internal class Attractors : GrowingTable() {
    var x = DoubleArray(0)
        private set
    var y = DoubleArray(0)
        private set
    var z = DoubleArray(0)
        private set
    var mass = DoubleArray(0)
        private set

    override fun resize(room: Int) {
        x = x.copyOf(room)
        y = y.copyOf(room)
        z = z.copyOf(room)
        mass = mass.copyOf(room)
    }

    fun add(x: Double, y: Double, z: Double, mass: Double) {
        val k = append()
        this.x[k] = x
        this.y[k] = y
        this.z[k] = z
        this.mass[k] = mass
    }
}
