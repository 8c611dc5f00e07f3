package daphnis.core.force

/** Point masses that attract: positions and masses of the first [size] entries. */
internal class Attractors {
    var x = DoubleArray(INITIAL)
        private set
    var y = DoubleArray(INITIAL)
        private set
    var z = DoubleArray(INITIAL)
        private set
    var mass = DoubleArray(INITIAL)
        private set
    var size = 0
        private set

    fun clear() {
        size = 0
    }

    fun add(x: Double, y: Double, z: Double, mass: Double) {
        if (size == this.mass.size) grow()
        this.x[size] = x
        this.y[size] = y
        this.z[size] = z
        this.mass[size++] = mass
    }

    private fun grow() {
        val n = size * 2
        x = x.copyOf(n)
        y = y.copyOf(n)
        z = z.copyOf(n)
        mass = mass.copyOf(n)
    }

    private companion object {
        const val INITIAL = 1024
    }
}
