package daphnis.core.population

import daphnis.core.population.FlowFit.Companion.FIRST
import daphnis.core.population.FlowFit.Companion.MASS
import daphnis.core.population.FlowFit.Companion.MOMENTUM
import daphnis.core.population.FlowFit.Companion.MOST_SLABS
import daphnis.core.population.FlowFit.Companion.OFFSET
import daphnis.core.population.FlowFit.Companion.SECOND
import daphnis.core.population.FlowFit.Companion.SLAB_WIDTH
import java.nio.ByteBuffer

/**
 * Second moments of the particles of a population around given means, as exact sums: different threads or machines may
 * take parts of a population, in any order, and merge them. Velocities w are without the straight flow of the
 * means and without the mean of the remainder. Allocates nothing once made.
 *
 * @param firstBody spheres with this id or a higher one are left out; [Int.MAX_VALUE] for none
 * @param carriesHeat whether [heat] is wanted
 */
internal class CentralMoments(private val flow: MeanFlow?, firstBody: Int, carriesHeat: Boolean = false) {
    private val normalAxis = flow?.normalAxis ?: 0
    private val sums = Array(SUMS) { ExactSum() }
    private val heat = Array(if (carriesHeat) 3 else 0) { ExactSum() }
    private val slabs = Array(if (flow == null) 0 else MOST_SLABS * SLAB_WIDTH) { ExactSum() }
    private var means = Means()

    // For one block, with the particles of each slab next to one another.
    private val block = ParticleBlock(firstBody)
    private val order = SlabOrder()
    private val m = column()
    private val w = Array(3) { column() }
    private val momentum = Array(3) { column() }
    private val across = column()
    private val height = column()
    private val terms = column()

    /** Σ m w_a w_b, with [e] counting xx, yy, zz, xy, xz, yz. */
    fun square(e: Int): Double = sums[SQUARES + e].value()

    /** Σ m z², where z is the height minus its mean. */
    val squareOfHeight: Double get() = sums[HEIGHT].value()

    /** Σ ½ m w² w_a, with [axis] for a. */
    fun heat(axis: Int): Double = heat[axis].value()

    /** Fills the sums over the flow that [fit] uses. */
    fun fill(fit: FlowFit) {
        fit.across = sums[ACROSS].value()
        for (axis in 0..2) fit.slopes[axis] = sums[SLOPES + axis].value()
        for (k in 0 until means.slabCount * SLAB_WIDTH) fit.slabs[k] = slabs[k].value()
    }

    /** Makes these the sums of no particles around [means], which must not change until the next call. */
    fun clear(means: Means) {
        this.means = means
        for (sum in sums) sum.clear()
        for (sum in heat) sum.clear()
        for (sum in slabs) sum.clear()
    }

    /** Adds the sums of [other], which are around the same means. */
    fun merge(other: CentralMoments) {
        for (k in sums.indices) sums[k].add(other.sums[k])
        for (k in heat.indices) heat[k].add(other.heat[k])
        for (k in slabs.indices) slabs[k].add(other.slabs[k])
    }

    /** Writes the sums in at most [MOST_BYTES], without their means, for [read]. */
    fun write(into: ByteBuffer) {
        for (sum in sums) sum.write(into)
        for (sum in heat) sum.write(into)
        for (k in 0 until filledSlabs()) slabs[k].write(into)
    }

    /**
     * Makes these the sums around [means] that [write] has written.
     *
     * @throws IllegalArgumentException for bytes that are no such sums; then these are the sums of no particles
     */
    fun read(means: Means, from: ByteBuffer) {
        clear(means)
        try {
            for (sum in sums) sum.read(from)
            for (sum in heat) sum.read(from)
            for (k in 0 until filledSlabs()) slabs[k].read(from)
        } catch (e: IllegalArgumentException) {
            clear(means)
            throw e
        }
    }

    private fun filledSlabs() = if (flow == null) 0 else means.slabCount * SLAB_WIDTH

    /** Adds the particles of [population] at the indices [from] until [to]. */
    fun add(population: Population, from: Int, to: Int) {
        ParticleBlock.forEach(from, to) { start, end ->
            block.collect(population, start, end)
            if (flow != null) order.sort(block, population.position(normalAxis), means)
            load(population)
            addSquares()
            if (heat.isNotEmpty()) addHeat()
            if (flow != null) addAcross()
        }
    }

    private fun load(p: Population) {
        val n = block.size
        val index = block.index
        val along = p.position(normalAxis)
        for (i in 0 until n) m[i] = p.mass[index[i]]
        for (i in 0 until n) height[i] = p.z[index[i]] - means.position[2]
        for (i in 0 until n) across[i] = along[index[i]] - means.position[normalAxis]
        for (axis in 0..2) {
            val v = p.velocity(axis)
            val w = w[axis]
            val momentum = momentum[axis]
            val rate = means.gradient[axis]
            val mean = means.velocity[axis]
            for (i in 0 until n) w[i] = v[index[i]] - rate * along[index[i]] - mean
            for (i in 0 until n) momentum[i] = m[i] * w[i]
        }
    }

    private fun addSquares() {
        for (e in 0 until 6) addProducts(SQUARES + e, momentum[FIRST[e]], w[SECOND[e]])
        for (i in 0 until block.size) terms[i] = m[i] * height[i]
        addProducts(HEIGHT, terms, height)
    }

    private fun addHeat() {
        val (wx, wy, wz) = w
        for (axis in 0..2) {
            val momentum = momentum[axis]
            for (i in 0 until block.size) {
                terms[i] = 0.5 * momentum[i] * (wx[i] * wx[i] + wy[i] * wy[i] + wz[i] * wz[i])
            }
            heat[axis].addAll(terms, 0, block.size)
        }
    }

    private fun addAcross() {
        val n = block.size
        for (axis in 0..2) addProducts(SLOPES + axis, momentum[axis], across)
        for (i in 0 until n) terms[i] = m[i] * across[i]
        for (slab in 0 until means.slabCount) addSlab(slab)
        addProducts(ACROSS, terms, across)
    }

    /** Σ m, Σ m y, Σ m w of the particles in [slab]; the terms are m y. */
    private fun addSlab(slab: Int) {
        val from = order.start(slab)
        val to = order.start(slab + 1)
        val s = slab * SLAB_WIDTH
        slabs[s + MASS].addAll(m, from, to)
        slabs[s + OFFSET].addAll(terms, from, to)
        for (axis in 0..2) slabs[s + MOMENTUM + axis].addAll(momentum[axis], from, to)
    }

    private fun addProducts(sum: Int, a: DoubleArray, b: DoubleArray) {
        for (i in 0 until block.size) terms[i] = a[i] * b[i]
        sums[sum].addAll(terms, 0, block.size)
    }

    private fun column() = DoubleArray(ParticleBlock.SPHERES)

    companion object {
        private const val SQUARES = 0
        private const val HEIGHT = 6
        private const val ACROSS = 7
        private const val SLOPES = 8
        private const val SUMS = 11

        /** Bytes of the longest that are written. */
        const val MOST_BYTES = (SUMS + 3 + MOST_SLABS * SLAB_WIDTH) * ExactSum.MOST_BYTES
    }
}
