package daphnis.core.collision

/** Sums over the collisions of two spheres: impact speeds, what was dissipated, the momentum that collisions carry. */
internal class PairSums : RecordSums() {
    /** Collisions by impact speed. */
    override val counts = LongArray(BINS)

    // Terms of collisions that are not yet in the sums, by sum.
    private val terms = Array(SUMS) { DoubleArray(BLOCK) }
    private var waiting = 0

    init {
        sum(SUMS - 1)
    }

    override fun add(record: CollisionRecord) {
        for (k in 0 until record.size) if (!record.isWall(k)) add(record, k)
        sumWaiting()
    }

    private fun sumWaiting() {
        for (k in terms.indices) sum(k).addAll(terms[k], 0, waiting)
        waiting = 0
    }

    private fun add(record: CollisionRecord, k: Int) {
        val speed = record.impactSpeed(k)
        val coefficient = record.coefficient(k)
        val impulse = record.impulse(k)
        if (waiting == BLOCK) sumWaiting()
        val at = waiting++
        val isEdge = record.isEdge(k)
        if (!isEdge) count++
        terms[SPEED][at] = if (isEdge) 0.0 else speed
        terms[SPEED_SQUARED][at] = if (isEdge) 0.0 else speed * speed
        if (speed > 0 && !isEdge) {
            counts[((StrictMath.log10(speed) - LEAST_DECADE) * BINS_A_DECADE).toInt().coerceIn(0, BINS - 1)]++
        }
        // impulse = μ (1 + ε) v_n, so the loss ½ μ (1 − ε²) v_n² is half of impulse · (1 − ε) · v_n.
        val restituted = if (isEdge) 0.0 else 0.5 * impulse * (1 - coefficient) * speed
        terms[DISSIPATED][at] = restituted + record.surfaceDissipation(k)
        val dx = record.separation(k, 0)
        val dy = record.separation(k, 1)
        val dz = record.separation(k, 2)
        val f = impulse / Math.sqrt(dx * dx + dy * dy + dz * dz)
        for (a in 0..2) {
            for (b in 0..2) {
                val along = record.tangentialImpulse(k, a) * record.separation(k, b)
                terms[VIRIAL + a * 3 + b][at] = f * record.separation(k, a) * record.separation(k, b) + along
            }
        }
    }

    companion object {
        const val TENSOR = 9

        // Numbers of the sums.
        const val SPEED = 0
        const val SPEED_SQUARED = 1
        const val DISSIPATED = 2
        const val VIRIAL = 3
        const val SUMS = VIRIAL + TENSOR
        private const val BLOCK = 256
        const val BINS_A_DECADE = 10
        const val LEAST_DECADE = -12
        private const val MOST_DECADE = 6
        const val BINS = (MOST_DECADE - LEAST_DECADE) * BINS_A_DECADE
    }
}
