package daphnis.core.population

import daphnis.core.population.IdRows.Companion.MASS
import daphnis.core.population.IdRows.Companion.POSITION
import daphnis.core.population.IdRows.Companion.VELOCITY
import daphnis.core.population.IdRows.Companion.WIDTH

/**
 * The sums of [PopulationSums] over one chunk of the places of a [table], [SUMS] numbers a chunk. Velocities w are
 * without the straight flow of the boundary's rate; positions and w are taken against those of the first particle, so
 * that squares do not cancel. Workers of a loop may do different chunks at the same time.
 */
internal class ChunkSums(private val table: IdRows, private val flow: MeanFlow?) {
    private val normalAxis = flow?.normalAxis ?: 0
    private val rate = DoubleArray(3).also { if (flow != null) it[flow.flowAxis] = flow.rate }

    /** The sums, by chunk · [SUMS] + column. */
    var sums = DoubleArray(0)
        private set

    /** Position of the first particle. */
    val origin = DoubleArray(3)

    /** Its velocity w. */
    val reference = DoubleArray(3)

    /** Slabs across the flow. */
    var slabCount = 1
        private set

    /** Number of chunks. */
    var count = 0
        private set
    private var particlePlaces = 0
    private var perSlab = 0.0

    /** Makes ready for the [table] as it is, with particles before [particlePlaces] and bodies from there on. */
    fun prepare(particlePlaces: Int, size: Int) {
        this.particlePlaces = particlePlaces
        count = (table.count + CHUNK - 1) / CHUNK
        if (sums.size < count * SUMS) sums = DoubleArray(count * SUMS)
        slabCount = (minOf(size, particlePlaces) / FlowFit.SPHERES_A_SLAB).coerceIn(1, FlowFit.MOST_SLABS)
        perSlab = if (table.greatest > table.least) slabCount / (table.greatest - table.least) else 0.0
        val rows = table.rows
        var place = 0
        while (place < particlePlaces && rows[place * WIDTH + MASS] == 0.0) place++
        val r = place * WIDTH
        val isThere = place < particlePlaces
        for (axis in 0..2) {
            origin[axis] = if (isThere) rows[r + POSITION + axis] else 0.0
            val flow = if (isThere) rate[axis] * rows[r + POSITION + normalAxis] else 0.0
            reference[axis] = if (isThere) rows[r + VELOCITY + axis] - flow else 0.0
        }
    }

    /** Fills the sums of [chunk]. */
    fun take(chunk: Int) {
        val out = chunk * SUMS
        sums.fill(0.0, out, out + SUMS)
        val from = chunk * CHUNK
        val end = minOf(table.count, from + CHUNK)
        val endOfParticles = minOf(particlePlaces, end)
        if (from < endOfParticles) {
            sumConserved(from, endOfParticles, out + PARTICLES)
            sumSquares(from, endOfParticles, out)
            if (flow != null) sumAcross(from, endOfParticles, out)
        }
        if (endOfParticles < end) sumConserved(maxOf(from, endOfParticles), end, out + BODIES)
    }

    // The kernels add up in local variables, few enough to be kept in registers.

    /** Number, Σ m, Σ m v²/2, Σ m v. */
    private fun sumConserved(from: Int, end: Int, out: Int) {
        var number = 0
        var mass = 0.0
        var energy = 0.0
        var px = 0.0
        var py = 0.0
        var pz = 0.0
        val rows = table.rows
        for (place in from until end) {
            val r = place * WIDTH
            val m = rows[r + MASS]
            val vx = rows[r + VELOCITY]
            val vy = rows[r + VELOCITY + 1]
            val vz = rows[r + VELOCITY + 2]
            if (m > 0) number++
            mass += m
            energy += m * (vx * vx + vy * vy + vz * vz)
            px += m * vx
            py += m * vy
            pz += m * vz
        }
        sums[out] = number.toDouble()
        sums[out + ALL_MASS] = mass
        sums[out + ENERGY] = energy / 2
        sums[out + MOMENTUM] = px
        sums[out + MOMENTUM + 1] = py
        sums[out + MOMENTUM + 2] = pz
    }

    /** Σ m w, Σ m w_a w_b, Σ m x, Σ m z, Σ m z². */
    private fun sumSquares(from: Int, end: Int, out: Int) {
        var sx = 0.0
        var sy = 0.0
        var sz = 0.0
        var xx = 0.0
        var yy = 0.0
        var zz = 0.0
        var xy = 0.0
        var xz = 0.0
        var yz = 0.0
        var x = 0.0
        var z = 0.0
        var height = 0.0
        val rows = table.rows
        for (place in from until end) {
            val r = place * WIDTH
            val m = rows[r + MASS]
            val a = rows[r + POSITION + normalAxis]
            val wx = rows[r + VELOCITY] - rate[0] * a - reference[0]
            val wy = rows[r + VELOCITY + 1] - rate[1] * a - reference[1]
            val wz = rows[r + VELOCITY + 2] - rate[2] * a - reference[2]
            val dz = rows[r + POSITION + 2] - origin[2]
            val px = m * wx
            val py = m * wy
            val pz = m * wz
            sx += px
            sy += py
            sz += pz
            xx += px * wx
            yy += py * wy
            zz += pz * wz
            xy += px * wy
            xz += px * wz
            yz += py * wz
            x += m * (rows[r + POSITION] - origin[0])
            z += m * dz
            height += m * dz * dz
        }
        store(out + SQUARES, xx, yy, zz)
        store(out + SQUARES + 3, xy, xz, yz)
        store(out + RELATIVE, sx, sy, sz)
        store(out + SUM_X, x, z, height)
    }

    /** Σ m y², Σ m y w_a, and by slab Σ m, Σ m y, Σ m w_a. */
    private fun sumAcross(from: Int, end: Int, out: Int) {
        var square = 0.0
        var sx = 0.0
        var sy = 0.0
        var sz = 0.0
        val rows = table.rows
        val sums = sums
        val first = out + SLABS
        val last = slabCount - 1
        // Whatever is read from memory would be read again after each store into the slabs.
        val least = table.least
        val perSlab = perSlab
        val middle = origin[normalAxis]
        val (rateX, rateY, rateZ) = rate
        val (ux, uy, uz) = reference
        for (place in from until end) {
            val r = place * WIDTH
            val m = rows[r + MASS]
            if (m == 0.0) continue
            val a = rows[r + POSITION + normalAxis]
            val y = a - middle
            val my = m * y
            val wx = rows[r + VELOCITY] - rateX * a - ux
            val wy = rows[r + VELOCITY + 1] - rateY * a - uy
            val wz = rows[r + VELOCITY + 2] - rateZ * a - uz
            square += my * y
            sx += my * wx
            sy += my * wy
            sz += my * wz
            val s = first + FlowFit.SLAB_WIDTH * Math.min(last, ((a - least) * perSlab).toInt())
            sums[s] += m
            sums[s + 1] += my
            sums[s + 2] += m * wx
            sums[s + 3] += m * wy
            sums[s + 4] += m * wz
        }
        sums[out + SQUARE_ACROSS] = square
        store(out + SLOPES, sx, sy, sz)
    }

    private fun store(at: Int, a: Double, b: Double, c: Double) {
        sums[at] = a
        sums[at + 1] = b
        sums[at + 2] = c
    }

    companion object {
        /** Places a chunk: some fifty microseconds of work. */
        private const val CHUNK = 4096

        // Number, mass, energy and momentum, of particles and of bodies.
        const val PARTICLES = 0
        const val BODIES = 6
        const val ALL_MASS = 1
        const val ENERGY = 2
        const val MOMENTUM = 3

        // Of particles.
        const val SQUARES = 12
        const val RELATIVE = 18
        const val SUM_X = 21
        const val SUM_Z = 22
        const val SQUARE_Z = 23
        const val SQUARE_ACROSS = 24
        const val SLOPES = 25
        const val SLABS = 28
        const val SUMS = SLABS + FlowFit.MOST_SLABS * FlowFit.SLAB_WIDTH
    }
}
