package daphnis.core.population

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
        least = Double.POSITIVE_INFINITY
        greatest = Double.NEGATIVE_INFINITY
    }

    /** Adds the sums of [other]. */
    fun merge(other: FirstMoments) {
        for (e in particles.indices) particles[e].add(other.particles[e])
        for (e in bodies.indices) bodies[e].add(other.bodies[e])
        count += other.count
        least = minOf(least, other.least)
        greatest = maxOf(greatest, other.greatest)
    }

    /** Adds the spheres of [population] at the indices [from] until [to]. */
    fun add(population: Population, from: Int, to: Int) {
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

    private companion object {
        const val MASS = 0
        const val MOMENTUM = 1
        const val SQUARES = 4
        const val POSITION = 5
        const val SUMS = 8
    }
}
