package daphnis.core.force

import daphnis.core.population.Population

/** The positions for which a force was last computed: it need not be computed again when no sphere has moved. */
internal class SeenPositions {
    private var x = DoubleArray(0)
    private var y = DoubleArray(0)
    private var z = DoubleArray(0)
    private var time = Double.NaN

    fun isSame(p: Population, time: Double): Boolean =
        time == this.time && x.size == p.size && x.contentEquals(p.x) && y.contentEquals(p.y) && z.contentEquals(p.z)

    fun forget() {
        time = Double.NaN
    }

    fun keep(p: Population, time: Double) {
        if (z.size != p.size) {
            x = DoubleArray(p.size)
            y = DoubleArray(p.size)
            z = DoubleArray(p.size)
        }
        p.x.copyInto(x)
        p.y.copyInto(y)
        p.z.copyInto(z)
        this.time = time
    }
}
