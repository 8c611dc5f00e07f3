package daphnis.analysis.insitu

/**
 * The velocities of the particles of a state minus the mean flow as it is measured: along a driven flow the straight
 * line that fits best, and then the mean of the rest in slabs across it, one for a hundred particles and at most twenty;
 * else the mean. Weighted by mass, as the granular temperature is (docs/analysis.md).
 */
internal class PeculiarVelocities(state: State) {
    private val p = state.population

    /** Indices of the particles in the population. */
    val particles: IntArray = (0 until p.size).filter { state.isParticle(it) }.toIntArray()
    private val flow = state.boundary.meanFlow
    private val mass = particles.sumOf { p.mass[it] }

    /** c of particle k, by axis. */
    val components: Array<DoubleArray> = Array(3) { axis ->
        around(DoubleArray(particles.size) { state.againstFlow(particles[it], axis) })
    }

    /** Degrees of freedom that the fit takes from the component along the flow, beside the mean. */
    private var taken = 0.0

    init {
        if (flow != null && particles.size > 2) takeOut(flow.normalAxis, components[flow.flowAxis])
    }

    /**
     * ⟨c_a²⟩ of particle [k] along [axis] over what it would be around the true flow, if every particle has the same
     * m⟨c_a²⟩: the particle is a part of its own mean.
     */
    fun freedom(k: Int, axis: Int): Double {
        val alongFlow = if (axis == flow?.flowAxis) taken / particles.size else 0.0
        return maxOf(0.0, 1 - p.mass[particles[k]] / mass - alongFlow)
    }

    /** [values] around their mean by mass. */
    private fun around(values: DoubleArray): DoubleArray {
        var sum = 0.0
        for (k in values.indices) sum += p.mass[particles[k]] * values[k]
        val mean = sum / mass
        return DoubleArray(values.size) { values[it] - mean }
    }

    private fun takeOut(normal: Int, c: DoubleArray) {
        val place = DoubleArray(particles.size) { p.position(normal)[particles[it]] }
        val y = around(place)
        val across = y.indices.sumOf { p.mass[particles[it]] * y[it] * y[it] }
        if (!(across > 0)) return
        val slope = y.indices.sumOf { p.mass[particles[it]] * y[it] * c[it] } / across
        for (k in c.indices) c[k] -= slope * y[k]
        val slabs = (particles.size / PARTICLES_A_SLAB).coerceIn(1, MOST_SLABS)
        val low = place.min()
        val width = (place.max() - low) / slabs
        val slab = IntArray(c.size) { ((place[it] - low) / width).toInt().coerceIn(0, slabs - 1) }
        val masses = DoubleArray(slabs)
        val moments = DoubleArray(slabs)
        val offsets = DoubleArray(slabs)
        for (k in c.indices) {
            val m = p.mass[particles[k]]
            masses[slab[k]] += m
            moments[slab[k]] += m * c[k]
            offsets[slab[k]] += m * y[k]
        }
        for (k in c.indices) c[k] -= moments[slab[k]] / masses[slab[k]]
        val filled = (0 until slabs).filter { masses[it] > 0 }
        // The line and the means of slabs have in common what of the line is between slabs.
        taken = filled.size - filled.sumOf { offsets[it] * offsets[it] / masses[it] } / across
    }

    private companion object {
        const val PARTICLES_A_SLAB = 100
        const val MOST_SLABS = 20
    }
}
