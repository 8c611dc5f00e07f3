package daphnis.core.run

import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord
import daphnis.core.population.ExactSum

/**
 * Sums over the collisions of two spheres in a run: number, impact speeds, and the momentum that collisions carry. They
 * are exact ([ExactSum]): the order of the collisions changes no bit. The simulation's collisional forcing must record
 * collisions.
 *
 * @property from collisions of steps that end at or before this time are left out
 */
public class CollisionStatistics @JvmOverloads constructor(public val from: Double = Double.NEGATIVE_INFINITY) :
    Output {
    /** Collisions summed. */
    public var count: Long = 0
        private set

    private val sums = Array(SUMS) { ExactSum() }

    // Terms of collisions that are not yet in the sums, by sum.
    private val terms = Array(SUMS) { DoubleArray(BLOCK) }
    private var waiting = 0

    /** Σ impact speed. */
    public val sumSpeed: Double get() = sums[SPEED].value()

    /** Σ impact speed². */
    public val sumSpeedSquared: Double get() = sums[SPEED_SQUARED].value()

    /**
     * Kinetic energy lost, that of spins with it: Σ ½ μ (1 − ε²) v_n², with μ the reduced mass, and of
     * [rough spheres][daphnis.core.surface.Roughness] ½ μ q/(1 + q) (1 − β²) g².
     */
    public val dissipated: Double get() = sums[DISSIPATED].value()

    /**
     * Σ Δp_a r_b over collisions, nine numbers by row: a·3 + b. Divided by volume and time it is the collisional part
     * of the pressure tensor, which is not symmetric while rough spheres are being spun up. A copy.
     */
    public val virial: DoubleArray get() = DoubleArray(TENSOR) { sums[VIRIAL + it].value() }

    /**
     * Collisions by impact speed, [BINS_A_DECADE] bins per decade from 10^[LEAST_DECADE]; the first and last also hold
     * what lies beyond.
     */
    public val speeds: LongArray = LongArray(BINS)

    private var lastStep = -1L

    /**
     * All sums as numbers, which a run that continues gives to [restore]: the number of collisions, the values of the
     * sums, and then the remainders of rounding those, as pairs of the sum's number and a part, at most 63 for each
     * sum.
     */
    public fun sums(): List<Double> = buildList {
        val parts = sums.map { it.parts() }
        add(count.toDouble())
        for (part in parts) add(part.firstOrNull() ?: 0.0)
        for (k in parts.indices) {
            for (rest in parts[k].drop(1)) {
                add(k.toDouble())
                add(rest)
            }
        }
    }

    /**
     * Takes over the [sums] and [speeds] of another object.
     *
     * @throws IllegalArgumentException for numbers that cannot be sums of collisions
     */
    public fun restore(sums: List<Double>, speeds: LongArray) {
        val pairs = sums.drop(1 + SUMS).chunked(2)
        val arePairs = pairs.all { it.size == 2 && (0 until SUMS).any { k -> k.toDouble() == it[0] } }
        val isPossible = arePairs && sums.size > SUMS && speeds.size == BINS
        require(isPossible) { "these are not the sums of collision statistics" }
        count = sums[0].toLong()
        for (k in 0 until SUMS) {
            this.sums[k].clear()
            this.sums[k].add(sums[1 + k])
        }
        for ((k, rest) in pairs) this.sums[k.toInt()].add(rest)
        speeds.copyInto(this.speeds)
    }

    override fun write(simulation: Simulation) {
        if (simulation.step == lastStep || simulation.step == 0L || simulation.time <= from) return
        lastStep = simulation.step
        val record = simulation.recordOfStep()
        for (k in 0 until record.size) if (!record.isWall(k)) add(record, k)
        sumWaiting()
    }

    private fun sumWaiting() {
        for (k in sums.indices) sums[k].addAll(terms[k], 0, waiting)
        waiting = 0
    }

    override fun save(state: OutputState) {
        state.put(SUMS_SAVED, sums().toDoubleArray())
        state.put(SPEEDS_SAVED, speeds)
    }

    override fun restore(state: OutputState) {
        restore(state.doubles(SUMS_SAVED).asList(), state.longs(SPEEDS_SAVED))
    }

    private fun add(record: CollisionRecord, k: Int) {
        val speed = record.impactSpeed(k)
        val coefficient = record.coefficient(k)
        val impulse = record.impulse(k)
        if (waiting == BLOCK) sumWaiting()
        val at = waiting++
        count++
        terms[SPEED][at] = speed
        terms[SPEED_SQUARED][at] = speed * speed
        if (speed > 0) {
            speeds[((StrictMath.log10(speed) - LEAST_DECADE) * BINS_A_DECADE).toInt().coerceIn(0, BINS - 1)]++
        }
        // impulse = μ (1 + ε) v_n, so the loss ½ μ (1 − ε²) v_n² is half of impulse · (1 − ε) · v_n.
        terms[DISSIPATED][at] = 0.5 * impulse * (1 - coefficient) * speed + record.surfaceDissipation(k)
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

    public companion object {
        private const val TENSOR = 9

        // The sums in the order in which they are written.
        private const val SPEED = 0
        private const val SPEED_SQUARED = 1
        private const val DISSIPATED = 2
        private const val VIRIAL = 3
        private const val SUMS = VIRIAL + TENSOR
        private const val BLOCK = 256
        internal const val SUMS_SAVED = "collisionSums"
        internal const val SPEEDS_SAVED = "impactSpeeds"
        public const val BINS_A_DECADE: Int = 10
        public const val LEAST_DECADE: Int = -12
        private const val MOST_DECADE = 6
        private const val BINS = (MOST_DECADE - LEAST_DECADE) * BINS_A_DECADE

        /** Lower edge of bin [k] of [speeds]. */
        @JvmStatic
        public fun binEdge(k: Int): Double = StrictMath.pow(10.0, LEAST_DECADE + k / BINS_A_DECADE.toDouble())
    }
}
