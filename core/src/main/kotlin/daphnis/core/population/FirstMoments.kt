package daphnis.core.population

import java.nio.ByteBuffer

/**
 * Mass, momentum, energy and first moments of the positions of some spheres of a population, as exact sums: different
 * threads or machines may take parts of a population, in any order, and merge them. Allocates nothing once made.
 *
 * @param axis along which the extent is measured
 * @param firstBody spheres with this id or a higher one are bodies: they have mass, momentum, energy and an extent, but
 *   are not particles; [Int.MAX_VALUE] for none
 */
internal class FirstMoments(private val axis: Int, firstBody: Int) {
    private val particles = Array(SUMS) { ExactSum() }
    private val bodies = Array(POSITION) { ExactSum() }
    private val block = ParticleBlock(firstBody)
    private val m = DoubleArray(ParticleBlock.SPHERES)
    private val terms = DoubleArray(ParticleBlock.SPHERES)

    /** Number of particles, without bodies. */
    var count = 0
        private set

    /** Number of particles and bodies. */
    var spheres = 0
        private set

    /** Least and greatest position along the axis, of particles and bodies; infinite when there are none. */
    var least = Double.POSITIVE_INFINITY
        private set
    var greatest = Double.NEGATIVE_INFINITY
        private set

    /** Σ m of particles and bodies. */
    val mass: Double get() = ofAll(MASS)

    /** Σ m v²/2 of particles and bodies. */
    val kineticEnergy: Double get() = ofAll(SQUARES) / 2

    /** Σ m v along [axis] of particles and bodies. */
    fun momentum(axis: Int): Double = ofAll(MOMENTUM + axis)

    /** Σ m of the particles. */
    val particleMass: Double get() = particles[MASS].value()

    /** Σ m v along [axis] of the particles. */
    fun particleMomentum(axis: Int): Double = particles[MOMENTUM + axis].value()

    /** Σ m x, y or z of the particles. */
    fun position(axis: Int): Double = particles[POSITION + axis].value()

    private val both = ExactSum()

    private fun ofAll(sum: Int): Double {
        both.clear()
        both.add(particles[sum])
        both.add(bodies[sum])
        return both.value()
    }

    /** Makes these the sums of no spheres. */
    fun clear() {
        for (sum in particles) sum.clear()
        for (sum in bodies) sum.clear()
        count = 0
        spheres = 0
        least = Double.POSITIVE_INFINITY
        greatest = Double.NEGATIVE_INFINITY
    }

    /** Adds the sums of [other]. */
    fun merge(other: FirstMoments) {
        for (e in particles.indices) particles[e].add(other.particles[e])
        for (e in bodies.indices) bodies[e].add(other.bodies[e])
        count += other.count
        spheres += other.spheres
        least = minOf(least, other.least)
        greatest = maxOf(greatest, other.greatest)
    }

    /** Makes these the sums over all parts of [partition], each of which does so. */
    fun mergeAll(partition: Partition) {
        partition.merge(particles + bodies)
        val counts = doubleArrayOf(count.toDouble(), spheres.toDouble())
        partition.add(counts)
        count = counts[0].toInt()
        spheres = counts[1].toInt()
        val ends = doubleArrayOf(-least, greatest)
        partition.max(ends)
        least = -ends[0]
        greatest = ends[1]
    }

    /** Writes the sums in at most [MOST_BYTES], for [read]. */
    fun write(into: ByteBuffer) {
        into.putInt(count).putInt(spheres).putDouble(least).putDouble(greatest)
        for (sum in particles) sum.write(into)
        for (sum in bodies) sum.write(into)
    }

    /**
     * Makes these the sums that [write] has written.
     *
     * @throws IllegalArgumentException for bytes that are no such sums; then these are the sums of no spheres
     */
    fun read(from: ByteBuffer) {
        clear()
        require(from.remaining() >= HEADER_BYTES) { "first moments are cut off" }
        val particlesRead = from.getInt()
        val spheresRead = from.getInt()
        val low = from.getDouble()
        val high = from.getDouble()
        require(particlesRead in 0..spheresRead) { "first moments of $particlesRead particles in $spheresRead spheres" }
        require(low <= high || spheresRead == 0) { "first moments of $spheresRead spheres from $low to $high" }
        try {
            for (sum in particles) sum.read(from)
            for (sum in bodies) sum.read(from)
        } catch (e: IllegalArgumentException) {
            clear()
            throw e
        }
        count = particlesRead
        spheres = spheresRead
        if (spheresRead == 0) return
        least = low
        greatest = high
    }

    /** Adds the spheres of [population] at the indices [from] until [to]. */
    fun add(population: Population, from: Int, to: Int) {
        spheres += to - from
        ParticleBlock.forEach(from, to) { start, end ->
            block.collect(population, start, end)
            addParticles(population)
            if (block.size < end - start) addBodies(population, start, end)
            measure(population, start, end)
        }
    }

    private fun addParticles(p: Population) {
        val index = block.index
        val n = block.size
        count += n
        for (i in 0 until n) m[i] = p.mass[index[i]]
        particles[MASS].addAll(m, 0, n)
        addProducts(MOMENTUM, p.vx)
        addProducts(MOMENTUM + 1, p.vy)
        addProducts(MOMENTUM + 2, p.vz)
        addProducts(POSITION, p.x)
        addProducts(POSITION + 1, p.y)
        addProducts(POSITION + 2, p.z)
        for (i in 0 until n) terms[i] = m[i] * speedSquared(p, index[i])
        particles[SQUARES].addAll(terms, 0, n)
    }

    /** Σ m [factor]. */
    private fun addProducts(sum: Int, factor: DoubleArray) {
        val index = block.index
        for (i in 0 until block.size) terms[i] = m[i] * factor[index[i]]
        particles[sum].addAll(terms, 0, block.size)
    }

    private fun addBodies(p: Population, from: Int, to: Int) {
        for (k in from until to) {
            if (!block.isBody(p.id[k])) continue
            bodies[MASS].add(p.mass[k])
            bodies[MOMENTUM].add(p.mass[k] * p.vx[k])
            bodies[MOMENTUM + 1].add(p.mass[k] * p.vy[k])
            bodies[MOMENTUM + 2].add(p.mass[k] * p.vz[k])
            bodies[SQUARES].add(p.mass[k] * speedSquared(p, k))
        }
    }

    private fun speedSquared(p: Population, k: Int): Double = p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]

    private fun measure(p: Population, from: Int, to: Int) {
        val along = p.position(axis)
        for (k in from until to) {
            if (along[k] < least) least = along[k]
            if (along[k] > greatest) greatest = along[k]
        }
    }

    companion object {
        private const val MASS = 0
        private const val MOMENTUM = 1
        private const val SQUARES = 4
        private const val POSITION = 5
        private const val SUMS = 8
        private const val HEADER_BYTES = 2 * Int.SIZE_BYTES + 2 * Double.SIZE_BYTES

        /** Bytes of the longest that are written. */
        const val MOST_BYTES = HEADER_BYTES + (SUMS + POSITION) * ExactSum.MOST_BYTES
    }
}
