package daphnis.analysis.diffusion

import daphnis.analysis.correlation.WaveSums
import daphnis.analysis.correlation.WaveVectors
import daphnis.analysis.insitu.State
import kotlin.math.cos
import kotlin.math.sin

/**
 * How the density forgets its waves: the intermediate scattering function F(k, t) = ⟨ρ_k(t₀ + t) ρ_k*(t₀)⟩/N with ρ_k =
 * Σ exp(i k·r), of all pairs of particles and not of each with itself as [SelfScattering] has it, averaged over origins
 * t₀ and over wave vectors that fit the box with |k| in [[from], [to]) (Hansen & McDonald, Theory of Simple Liquids,
 * ch. 7.4). F(k, 0) is the structure factor S(k). Of many vectors [most] are taken, spread over the shell.
 *
 * States are given to [add] in order of time, all in one box that repeats along all axes, at rest; of discs along x and
 * y. Places are relative to the centre of mass. A state costs a product for each particle and vector, and is not kept.
 *
 * Lags are those of [SelfScattering], and 0. Errors are from blocks of time as long as the lag.
 *
 * @param from in 1/length
 */
public class IntermediateScattering @JvmOverloads constructor(
    public val from: Double,
    public val to: Double,
    private val most: Int = 48,
) {
    private val times = ArrayList<Double>()

    /** `[time][2 · vector]`: cosine, sine. */
    private val waves = ArrayList<DoubleArray>()
    private var vectors: WaveVectors? = null
    private var particles = 0

    /** How far the centre of mass has gone, and its velocity at the last time. */
    private val gone = DoubleArray(AXES)
    private val centreVelocity = DoubleArray(AXES)

    init {
        require(from >= 0 && to > from && to.isFinite()) { "wave numbers in [$from, $to); there is none" }
        require(most >= 1) { "$most wave vectors at most; there must be 1" }
    }

    /** Number of times. */
    public val size: Int get() = times.size

    /** Wave vectors that are averaged over; 0 before the first state, or where none fits. */
    public val vectorCount: Int get() = vectors?.size ?: 0

    /** Mean |k| of these, in 1/length; NaN without any. */
    public val waveNumber: Double
        get() = vectors?.let { v -> (0 until v.size).map { v.length(it) }.average() } ?: Double.NaN

    /**
     * Takes in one more state, later than those before.
     *
     * @throws IllegalArgumentException when it is not later, or has another number of particles or a sheared box
     */
    public fun add(state: State) {
        require(times.isEmpty() || state.time > times.last()) {
            "a state at time ${state.time} after one at ${times.last()}; times must ascend"
        }
        require((0 until state.dimensions).all { state.boundary.hasImages(it) } && state.boundary.shear == null) {
            "waves are of a box at rest that repeats along all axes"
        }
        val indices = (0 until state.population.size).filter { state.isParticle(it) }.toIntArray()
        require(times.isEmpty() || indices.size == particles) { "${indices.size} particles, before $particles" }
        particles = indices.size
        val v = vectors ?: WaveVectors(state.boundary, state.time, to, 1, most, from).also { vectors = it }
        val (c, s) = WaveSums(state, v).over(indices, listOf(null))[0]
        follow(state, indices)
        times += state.time
        waves += DoubleArray(2 * v.size).also { wave ->
            for (j in 0 until v.size) {
                val turn = (0 until AXES).sumOf { v.component(it, j) * gone[it] }
                wave[2 * j] = c[j] * cos(turn) + s[j] * sin(turn)
                wave[2 * j + 1] = s[j] * cos(turn) - c[j] * sin(turn)
            }
        }
    }

    private fun follow(state: State, indices: IntArray) {
        val p = state.population
        val since = if (times.isEmpty()) 0.0 else state.time - times.last()
        val mass = indices.sumOf { p.mass[it] }
        for (axis in 0 until AXES) {
            gone[axis] += centreVelocity[axis] * since
            centreVelocity[axis] = indices.sumOf { p.mass[it] * p.velocity(axis)[it] } / mass
        }
    }

    /**
     * F by lag with its errors.
     *
     * @throws IllegalStateException for fewer than [MeanSquareDisplacement.FEWEST_TIMES] times, or without a wave vector
     */
    public fun function(): Function {
        check(size >= MeanSquareDisplacement.FEWEST_TIMES && vectorCount > 0) {
            "$size times and $vectorCount wave vectors; there must be ${MeanSquareDisplacement.FEWEST_TIMES} and one"
        }
        val steps = intArrayOf(0) + Lags.upToHalf(size)
        val series = steps.map { step -> DoubleArray(size - step) { product(waves[it], waves[it + step]) } }
        return Function(
            DoubleArray(steps.size) { Lags.mean(size, steps[it], times::get) },
            DoubleArray(steps.size) { series[it].average() },
            DoubleArray(steps.size) { OverOrigins.error(series[it], maxOf(1, steps[it])) },
        )
    }

    private fun product(a: DoubleArray, b: DoubleArray): Double {
        var sum = 0.0
        for (k in a.indices) sum += a[k] * b[k]
        return sum / (particles.toDouble() * vectorCount)
    }

    /**
     * F(k, t) by lag.
     *
     * @property lag in units of time, ascending, the first 0
     * @property scattering F; its first is S(k)
     * @property error one standard error of [scattering]; NaN at lags that are too long for the time
     */
    public class Function internal constructor(
        public val lag: DoubleArray,
        public val scattering: DoubleArray,
        public val error: DoubleArray,
    )

    private companion object {
        const val AXES = 3
    }
}
