package daphnis.core.run

import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.collision.PairSums
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
    private val pairs = PairSums()

    /** Collisions summed. */
    public val count: Long get() = pairs.count

    /** Σ impact speed. */
    public val sumSpeed: Double get() = pairs.value(PairSums.SPEED)

    /** Σ impact speed². */
    public val sumSpeedSquared: Double get() = pairs.value(PairSums.SPEED_SQUARED)

    /**
     * Kinetic energy lost, that of spins with it: Σ ½ μ (1 − ε²) v_n², with μ the reduced mass, and of
     * [rough spheres][daphnis.core.surface.Roughness] ½ μ q/(1 + q) (1 − β²) g².
     */
    public val dissipated: Double get() = pairs.value(PairSums.DISSIPATED)

    /**
     * Σ Δp_a r_b over collisions, nine numbers by row: a·3 + b. Divided by volume and time it is the collisional part
     * of the pressure tensor, which is not symmetric while rough spheres are being spun up. A copy.
     */
    public val virial: DoubleArray get() = DoubleArray(PairSums.TENSOR) { pairs.value(PairSums.VIRIAL + it) }

    /**
     * Collisions by impact speed, [BINS_A_DECADE] bins per decade from 10^[LEAST_DECADE]; the first and last also hold
     * what lies beyond.
     */
    public val speeds: LongArray get() = pairs.counts

    private var lastStep = -1L

    /**
     * All sums as numbers, which a run that continues gives to [restore]: the number of collisions, the values of the
     * sums, and then the remainders of rounding those, as pairs of the sum's number and a part, at most 63 for each
     * sum.
     */
    public fun sums(): List<Double> = buildList {
        val parts = List(SUMS) { pairs.sum(it).parts() }
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
        val rests = sums.drop(1 + SUMS).chunked(2)
        val arePairs = rests.all { it.size == 2 && (0 until SUMS).any { k -> k.toDouble() == it[0] } }
        val isPossible = arePairs && sums.size > SUMS && speeds.size == this.speeds.size
        require(isPossible) { "these are not the sums of collision statistics" }
        pairs.clear()
        pairs.count = sums[0].toLong()
        for (k in 0 until SUMS) pairs.sum(k).add(sums[1 + k])
        for ((k, rest) in rests) pairs.sum(k.toInt()).add(rest)
        speeds.copyInto(this.speeds)
    }

    override fun write(simulation: Simulation) {
        if (simulation.step == lastStep || simulation.step == 0L || simulation.time <= from) return
        lastStep = simulation.step
        simulation.addStepTo(pairs)
    }

    override fun save(state: OutputState) {
        state.put(SUMS_SAVED, sums().toDoubleArray())
        state.put(SPEEDS_SAVED, speeds)
    }

    override fun restore(state: OutputState) {
        restore(state.doubles(SUMS_SAVED).asList(), state.longs(SPEEDS_SAVED))
    }

    public companion object {
        private const val SUMS = PairSums.SUMS
        internal const val SUMS_SAVED = "collisionSums"
        internal const val SPEEDS_SAVED = "impactSpeeds"
        public const val BINS_A_DECADE: Int = PairSums.BINS_A_DECADE
        public const val LEAST_DECADE: Int = PairSums.LEAST_DECADE

        /** Lower edge of bin [k] of [speeds]. */
        @JvmStatic
        public fun binEdge(k: Int): Double = StrictMath.pow(10.0, LEAST_DECADE + k / BINS_A_DECADE.toDouble())
    }
}
