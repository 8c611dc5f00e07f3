package daphnis.core.population

/**
 * Granular temperature ⟨c²⟩/3, weighted by mass, with c the peculiar velocity: what is left of the velocity when the mean is taken out
 * and, if there is one, the mean [flow] as well: the straight line that fits best, then the mean of what remains in slabs across it
 * (one a hundred spheres, at most twenty), since a driven flow need not be straight. In (length/time)². Sums in id order; allocates five columns.
 */
public fun granularTemperature(population: Population, flow: MeanFlow?): Double {
    val sums = VelocitySums(population, flow?.normalAxis ?: 1, flow?.flowAxis ?: 0)
    if (sums.mass == 0.0) return 0.0
    val square = sums.squareAroundMean()
    val ofFlow = if (flow != null) sums.squareOfMeanFlow() else 0.0
    return maxOf(0.0, square - ofFlow) / sums.mass / 3
}

/** Mass-weighted sums over a population in id order. The columns are brought into that order once, so that the passes run along memory. */
private class VelocitySums(population: Population, normalAxis: Int, flowAxis: Int) {
    private val size = population.size
    private val m = DoubleArray(size)

    // Position across the flow, velocity along it, the other two components.
    private val y = DoubleArray(size)
    private val u = DoubleArray(size)
    private val v = DoubleArray(size)
    private val w = DoubleArray(size)
    val mass: Double

    init {
        val positions = arrayOf(population.x, population.y, population.z)
        val velocities = arrayOf(population.vx, population.vy, population.vz)
        val others = (0..2).filter { it != flowAxis }
        var n = 0
        for (id in 0 until population.idBound) {
            val k = population.indexOf(id)
            if (k < 0) continue
            m[n] = population.mass[k]
            y[n] = positions[normalAxis][k]
            u[n] = velocities[flowAxis][k]
            v[n] = velocities[others[0]][k]
            w[n] = velocities[others[1]][k]
            n++
        }
        var sum = 0.0
        for (k in 0 until size) sum += m[k]
        mass = sum
        for (column in listOf(y, u, v, w)) subtractMean(column)
    }

    private fun subtractMean(column: DoubleArray) {
        var sum = 0.0
        for (k in 0 until size) sum += m[k] * column[k]
        val mean = sum / mass
        for (k in 0 until size) column[k] -= mean
    }

    fun squareAroundMean(): Double {
        var square = 0.0
        for (k in 0 until size) square += m[k] * (u[k] * u[k] + v[k] * v[k] + w[k] * w[k])
        return square
    }

    /** Σ m (mean flow)²: what the straight line explains, and what slab means explain of the rest. */
    fun squareOfMeanFlow(): Double {
        var yy = 0.0
        var yu = 0.0
        var least = Double.POSITIVE_INFINITY
        var most = Double.NEGATIVE_INFINITY
        for (k in 0 until size) {
            yy += m[k] * y[k] * y[k]
            yu += m[k] * y[k] * u[k]
            least = minOf(least, y[k])
            most = maxOf(most, y[k])
        }
        if (yy == 0.0) return 0.0
        val slope = yu / yy
        val slabs = (size / SPHERES_A_SLAB).coerceIn(1, MOST_SLABS)
        val slabMass = DoubleArray(slabs)
        val slabRest = DoubleArray(slabs)
        for (k in 0 until size) {
            val slab = ((y[k] - least) / (most - least) * slabs).toInt().coerceIn(0, slabs - 1)
            slabMass[slab] += m[k]
            slabRest[slab] += m[k] * (u[k] - slope * y[k])
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
