package daphnis.core.run

import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord

/**
 * Sums over the collisions of a run: number, impact speeds, and the momentum that collisions carry. The simulation's
 * collisional forcing must record collisions.
 *
 * @property from collisions of steps that end at or before this time are left out
 */
public class CollisionStatistics(public val from: Double = Double.NEGATIVE_INFINITY) : Output {
    /** Collisions summed. */
    public var count: Long = 0
        private set

    /** Σ impact speed. */
    public var sumSpeed: Double = 0.0
        private set

    /** Σ impact speed². */
    public var sumSpeedSquared: Double = 0.0
        private set

    /** Kinetic energy lost: Σ ½ μ (1 − ε²) v_n², with μ the reduced mass. */
    public var dissipated: Double = 0.0
        private set

    /**
     * Σ Δp_a r_b over collisions, nine numbers by row: a·3 + b. Divided by volume and time it is the collisional part
     * of the pressure tensor.
     */
    public val virial: DoubleArray = DoubleArray(TENSOR)

    /**
     * Collisions by impact speed, [BINS_A_DECADE] bins a decade from 10^[LEAST_DECADE]; the first and last take what
     * lies beyond.
     */
    public val speeds: LongArray = LongArray(BINS)

    private var lastStep = -1L

    /** All sums as numbers, to be given to [restore] by a run that goes on. */
    public fun sums(): List<Double> = listOf(count.toDouble(), sumSpeed, sumSpeedSquared, dissipated) + virial.asList()

    /** Takes over what [sums] and [speeds] of another were. */
    public fun restore(sums: List<Double>, speeds: LongArray) {
        require(sums.size == 4 + TENSOR && speeds.size == BINS) { "these are not the sums of collision statistics" }
        count = sums[0].toLong()
        sumSpeed = sums[1]
        sumSpeedSquared = sums[2]
        dissipated = sums[3]
        for (k in 0 until TENSOR) virial[k] = sums[4 + k]
        speeds.copyInto(this.speeds)
    }

    override fun write(simulation: Simulation) {
        if (simulation.step == lastStep || simulation.step == 0L || simulation.time <= from) return
        lastStep = simulation.step
        val record =
            checkNotNull(simulation.collisions?.record) {
                "collisions are not recorded; make CollisionForcing with recordCollisions = true"
            }
        for (k in 0 until record.size) add(record, k)
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
        count++
        sumSpeed += speed
        sumSpeedSquared += speed * speed
        if (speed > 0) {
            speeds[((StrictMath.log10(speed) - LEAST_DECADE) * BINS_A_DECADE).toInt().coerceIn(0, BINS - 1)]++
        }
        // impulse = μ (1 + ε) v_n, so the loss ½ μ (1 − ε²) v_n² is half of impulse · (1 − ε) · v_n.
        dissipated += 0.5 * impulse * (1 - coefficient) * speed
        val dx = record.separation(k, 0)
        val dy = record.separation(k, 1)
        val dz = record.separation(k, 2)
        val f = impulse / Math.sqrt(dx * dx + dy * dy + dz * dz)
        for (a in 0..2) for (b in 0..2) virial[a * 3 + b] += f * record.separation(k, a) * record.separation(k, b)
    }

    public companion object {
        private const val TENSOR = 9
        internal const val SUMS_SAVED = "collisionSums"
        internal const val SPEEDS_SAVED = "impactSpeeds"
        public const val BINS_A_DECADE: Int = 10
        public const val LEAST_DECADE: Int = -12
        private const val MOST_DECADE = 6
        private const val BINS = (MOST_DECADE - LEAST_DECADE) * BINS_A_DECADE

        /** Lower edge of bin [k] of [speeds]. */
        public fun binEdge(k: Int): Double = StrictMath.pow(10.0, LEAST_DECADE + k / BINS_A_DECADE.toDouble())
    }
}
