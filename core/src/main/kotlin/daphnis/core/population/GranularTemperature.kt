package daphnis.core.population

/**
 * Granular temperature ⟨c²⟩/3, weighted by mass, with c the peculiar velocity: what is left of the velocity when the mean is taken out
 * and, if [sheared], the mean flow v_x(y) as well: the straight line that fits best, then the mean of what remains in slabs of y
 * (one a hundred spheres, at most twenty), since a driven flow need not be straight. In (length/time)². Sums in id order.
 */
public fun granularTemperature(population: Population, sheared: Boolean): Double {
    val sums = VelocitySums(population)
    if (sums.mass == 0.0) return 0.0
    val square = sums.squareAroundMean()
    val flow = if (sheared) sums.squareOfMeanFlow() else 0.0
    return maxOf(0.0, square - flow) / sums.mass / 3
}

/** Mass-weighted sums over a population in id order. */
private class VelocitySums(private val population: Population) {
    private val order = IntArray(population.size)
    val mass: Double
    private val meanY: Double
    private val mean = DoubleArray(3)

    init {
        var n = 0
        var m = 0.0
        var y = 0.0
        for (id in 0 until population.idBound) {
            val k = population.indexOf(id)
            if (k < 0) continue
            order[n++] = k
            val mk = population.mass[k]
            m += mk
            y += mk * population.y[k]
            mean[0] += mk * population.vx[k]
            mean[1] += mk * population.vy[k]
            mean[2] += mk * population.vz[k]
        }
        mass = m
        meanY = y / m
        for (axis in 0..2) mean[axis] /= m
    }

    fun squareAroundMean(): Double {
        var square = 0.0
        for (k in order) {
            val u = population.vx[k] - mean[0]
            val v = population.vy[k] - mean[1]
            val w = population.vz[k] - mean[2]
            square += population.mass[k] * (u * u + v * v + w * w)
        }
        return square
    }

    /** Σ m (mean flow)²: what the straight line explains, and what slab means explain of the rest. */
    fun squareOfMeanFlow(): Double {
        var yy = 0.0
        var yu = 0.0
        var least = Double.POSITIVE_INFINITY
        var most = Double.NEGATIVE_INFINITY
        for (k in order) {
            val y = population.y[k] - meanY
            yy += population.mass[k] * y * y
            yu += population.mass[k] * y * (population.vx[k] - mean[0])
            least = minOf(least, y)
            most = maxOf(most, y)
        }
        if (yy == 0.0) return 0.0
        val slope = yu / yy
        val slabs = (order.size / SPHERES_A_SLAB).coerceIn(1, MOST_SLABS)
        val slabMass = DoubleArray(slabs)
        val slabRest = DoubleArray(slabs)
        for (k in order) {
            val y = population.y[k] - meanY
            val slab = ((y - least) / (most - least) * slabs).toInt().coerceIn(0, slabs - 1)
            slabMass[slab] += population.mass[k]
            slabRest[slab] += population.mass[k] * (population.vx[k] - mean[0] - slope * y)
        }
        var explained = yu * slope
        for (slab in 0 until slabs) if (slabMass[slab] > 0) explained += slabRest[slab] * slabRest[slab] / slabMass[slab]
        return explained
    }

    private companion object {
        const val SPHERES_A_SLAB = 100
        const val MOST_SLABS = 20
    }
}
