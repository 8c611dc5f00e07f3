package daphnis.core.wave

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.isChanging
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.ExactSum
import daphnis.core.population.ParticleBlock
import daphnis.core.population.Population
import daphnis.core.population.Workers
import kotlin.math.PI

/** What [ModeSums] has modes of. */
public enum class ModeQuantity {
    /** Surface density over its mean: mode 0 is 1. */
    DENSITY,

    /** v_x without the boundary's flow, a velocity. */
    VELOCITY_X,

    /** v_y without the boundary's flow, a velocity. */
    VELOCITY_Y,

    /** Local granular temperature, a velocity squared. */
    TEMPERATURE,
}

/**
 * Fourier modes of a population along [axis]: radially in Hill's frame, with k_m = 2π m/L of the box. Made once and
 * filled by [take]; allocates nothing once warm. Sums are exact ([ExactSum]), so the modes are the same to the last bit
 * for every order of the arrays and number of threads.
 *
 * The mode of q is 2 ⟨(q − q₀) exp(−i k_m x)⟩, q₀ = ⟨q⟩ and both averages over the particles by mass; x is the position
 * in the frame, whose origin is in the middle of a box that is given by its lengths. So q is q₀ + Re Σ q_m
 * exp(i k_m x), its crest is at x = −arg(q_m)/k_m, and where a wave goes outward the phase falls with time. That is
 * exact for the surface density; for the others, which are weighted by mass, it holds to first order in the density's
 * modes. Mode 0 is q₀, and for the density 1.
 *
 * The temperature is local: |c|²/3 (in the plane /2), with c around the *field of the modes* in x and y and around the
 * mean in z. That field has the same wavenumbers up to [modes] and fits the velocities best by least squares, weighted
 * by mass. The squares of c are corrected for the degrees of freedom that the fit takes, 2 [modes] + 1 from each of
 * both components. Motion at wavelengths shorter than that of the last mode counts as temperature. It is NaN where
 * there are no more particles than that, or where they do not tell the field.
 *
 * @property modes number of modes beside mode 0, 1 to [MOST_MODES]
 * @param firstBody spheres with this id or a higher one are left out, such as moonlets; [Int.MAX_VALUE] for none
 * @throws IllegalArgumentException for another number of modes, or a box that does not repeat along [axis]
 */
public class ModeSums @JvmOverloads constructor(
    public val modes: Int,
    boundary: BoundaryConditions,
    private val firstBody: Int = Int.MAX_VALUE,
) {
    init {
        require(modes in 1..MOST_MODES) { "$modes modes; there must be 1 to $MOST_MODES" }
        problem(boundary)?.let { throw IllegalArgumentException(it) }
    }

    private val flow = boundary.meanFlow
    private val dimensions = boundary.space.dimensions

    /** The axis of the wave vectors: across the flow that the boundary drives, else x. */
    public val axis: Int = axisOf(boundary)
    private val first = 2 * PI / boundary.box.length(axis)
    private val field = ModeField(modes)
    private var population: Population? = null
    private val shares = Workers { Share() }
    private val takeFirst = RangeBody { worker, from, to -> shares[worker].addFirst(population!!, from, to) }
    private val takeSecond = RangeBody { worker, from, to -> shares[worker].addSecond(population!!, from, to) }
    private var overPlane = Double.NaN
    private var overHeight = Double.NaN
    private var meanHeightSpeed = 0.0
    private val values = Array(ModeQuantity.entries.size) { DoubleArray(2 * (modes + 1)) }

    /** k_m, per unit of length. */
    public fun wavenumber(m: Int): Double = first * m

    /** Real part of mode [m] of [quantity], m from 0 to [modes]; NaN without particles. */
    public fun real(quantity: ModeQuantity, m: Int): Double = values[quantity.ordinal][2 * m]

    /** Imaginary part; 0 for [m] = 0. */
    public fun imaginary(quantity: ModeQuantity, m: Int): Double = values[quantity.ordinal][2 * m + 1]

    /** Takes the modes of the present state of [population] on the threads of [loop]. */
    @JvmOverloads
    public fun take(population: Population, loop: RangeLoop = InlineLoop) {
        this.population = population
        try {
            shares.upTo(maxOf(1, loop.workers))
            take(population.size, loop)
        } finally {
            this.population = null
        }
    }

    private fun take(size: Int, loop: RangeLoop) {
        val sums = shares[0]
        for (k in 0 until shares.count) shares[k].clear()
        loop.run(size, takeFirst)
        for (k in 1 until shares.count) sums.mergeFirst(shares[k])
        val mass = sums.masses.cosine(0)
        val left = sums.count - 2.0 * modes - 1
        val isTold = left > 0 && field.fit(sums.masses, sums.momenta)
        overPlane = if (isTold) sums.count / left / dimensions else Double.NaN
        overHeight = if (isTold) sums.count / (sums.count - 1.0) / dimensions else Double.NaN
        meanHeightSpeed = sums.vertical.value() / mass
        loop.run(size, takeSecond)
        for (k in 1 until shares.count) sums.heat.merge(shares[k].heat)
        fill(ModeQuantity.VELOCITY_X, sums.momenta[0], sums.masses)
        fill(ModeQuantity.VELOCITY_Y, sums.momenta[1], sums.masses)
        fill(ModeQuantity.TEMPERATURE, sums.heat, sums.masses)
        val density = values[ModeQuantity.DENSITY.ordinal]
        density[0] = if (mass > 0) 1.0 else Double.NaN
        for (m in 1..modes) {
            density[2 * m] = 2 * sums.masses.cosine(m) / mass
            density[2 * m + 1] = -2 * sums.masses.sine(m) / mass
        }
    }

    private fun fill(quantity: ModeQuantity, of: HarmonicSums, masses: HarmonicSums) {
        val mass = masses.cosine(0)
        val into = values[quantity.ordinal]
        val mean = of.cosine(0) / mass
        into[0] = mean
        for (m in 1..modes) {
            into[2 * m] = 2 * (of.cosine(m) - mean * masses.cosine(m)) / mass
            into[2 * m + 1] = -2 * (of.sine(m) - mean * masses.sine(m)) / mass
        }
    }

    /** What one thread sums up; that of the first takes over those of the others. */
    private inner class Share {
        val masses = HarmonicSums(2 * modes)
        val momenta = Array(ModeField.COMPONENTS) { HarmonicSums(modes) }
        val vertical = ExactSum()
        val heat = HarmonicSums(modes)
        var count = 0
        private val block = ParticleBlock(firstBody)
        private val phases = HarmonicPhases(first)
        private val m = column()
        private val w = Array(ModeField.COMPONENTS) { column() }
        private val terms = column()
        private val square = column()

        fun clear() {
            masses.clear()
            for (sums in momenta) sums.clear()
            vertical.clear()
            heat.clear()
            count = 0
        }

        fun mergeFirst(other: Share) {
            masses.merge(other.masses)
            for (component in momenta.indices) momenta[component].merge(other.momenta[component])
            vertical.add(other.vertical)
            count += other.count
        }

        fun addFirst(p: Population, from: Int, to: Int) = ParticleBlock.forEach(from, to) { start, end ->
            load(p, start, end)
            val n = block.size
            count += n
            for (i in 0 until n) terms[i] = m[i] * p.vz[block.index[i]]
            vertical.addAll(terms, 0, n)
            for (component in w) for (i in 0 until n) component[i] *= m[i]
            for (harmonic in 0..2 * modes) {
                if (harmonic > 0) phases.next()
                masses.add(phases, m, n)
                if (harmonic > modes) continue
                for (component in w.indices) momenta[component].add(phases, w[component], n)
            }
        }

        fun addSecond(p: Population, from: Int, to: Int) = ParticleBlock.forEach(from, to) { start, end ->
            load(p, start, end)
            val n = block.size
            for (harmonic in 0..modes) {
                if (harmonic > 0) phases.next()
                for (component in w.indices) {
                    val a = field.cosine(component, harmonic)
                    val b = field.sine(component, harmonic)
                    val rest = w[component]
                    for (i in 0 until n) rest[i] -= a * phases.cosine[i] + b * phases.sine[i]
                }
            }
            for (i in 0 until n) {
                val height = p.vz[block.index[i]] - meanHeightSpeed
                val inPlane = w[0][i] * w[0][i] + w[1][i] * w[1][i]
                square[i] = m[i] * (inPlane * overPlane + height * height * overHeight)
            }
            phases.rewind()
            for (harmonic in 0..modes) {
                if (harmonic > 0) phases.next()
                heat.add(phases, square, n)
            }
        }

        private fun load(p: Population, from: Int, to: Int) {
            block.collect(p, from, to)
            phases.begin(block, p.position(axis))
            for (i in 0 until block.size) m[i] = p.mass[block.index[i]]
            for (component in w.indices) {
                val v = p.velocity(component)
                val along = p.position(flow?.normalAxis ?: 0)
                val rate = if (flow != null && flow.flowAxis == component) flow.rate else 0.0
                for (i in 0 until block.size) {
                    w[component][i] = v[block.index[i]] - rate * along[block.index[i]]
                }
            }
        }

        private fun column() = DoubleArray(ParticleBlock.SPHERES)
    }

    public companion object {
        /** The largest number of modes. */
        public const val MOST_MODES: Int = 64

        private fun axisOf(boundary: BoundaryConditions) = boundary.meanFlow?.normalAxis ?: 0

        /** Why there are no modes in [boundary], as a sentence without its subject; null when there are. */
        internal fun problem(boundary: BoundaryConditions): String? {
            val axis = axisOf(boundary)
            if (boundary.isChanging) return "needs a box that stays as long as it is; set boundary.perturbation to 0"
            if (boundary.repeats(axis)) return null
            return "needs a box that repeats along ${"xyz"[axis]}, along which the modes are"
        }
    }
}
