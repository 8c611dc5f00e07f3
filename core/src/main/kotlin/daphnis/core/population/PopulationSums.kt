package daphnis.core.population

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.IdRows.Companion.MASS
import daphnis.core.population.IdRows.Companion.POSITION
import daphnis.core.population.IdRows.Companion.VELOCITY
import daphnis.core.population.IdRows.Companion.WIDTH
import kotlin.math.sqrt

/**
 * What a row of `series.csv` and of `transport.csv` says of a population: mass, momentum, energy, and the moments of its velocities. Made once and filled by
 * [take] for each row; allocates nothing once warm. One thread calls; the loop given to [take] may use more.
 *
 * Sums are taken over fixed chunks of ids and the chunks added in their order: the same to the last bit for every order of the arrays, engine and number of
 * threads.
 *
 * @param flow the mean flow that the boundary drives, or null
 * @param omega angular speed of Hill's frame, or null
 * @param leastBody spheres with ids from this on are bodies, such as moonlets: they count for mass, momentum and energy, and for nothing else
 */
public class PopulationSums(private val flow: MeanFlow?, private val omega: Double? = null, private val leastBody: Int = Int.MAX_VALUE) {
    private val table = IdRows()
    private val fit = FlowFit(flow?.flowAxis ?: -1)
    private val normalAxis = flow?.normalAxis ?: 0
    private val rate = DoubleArray(3).also { if (flow != null) it[flow.flowAxis] = flow.rate }

    // Sums of each chunk, then those of all; written by the worker of the chunk, read after the loop.
    private var chunks = DoubleArray(0)
    private val sums = DoubleArray(SUMS)
    private val sumChunks = RangeBody { _, from, to -> for (chunk in from until to) sum(chunk) }

    // Of the row at hand: numbers of places, and slabs.
    private var places = 0
    private var particlePlaces = 0
    private var perSlab = 0.0
    private var slabCount = 0

    // Position and velocity w of the first particle, against which sums are taken, so that squares do not cancel.
    private val origin = DoubleArray(3)
    private val reference = DoubleArray(3)

    /** Number of spheres, bodies included. */
    public var count: Int = 0
        private set

    /** Σ m of particles and bodies. */
    public val mass: Double get() = sums[PARTICLES + 1] + sums[BODIES + 1]

    /** Σ m v²/2 of particles and bodies. */
    public val kineticEnergy: Double get() = sums[PARTICLES + ENERGY] + sums[BODIES + ENERGY]

    /** Σ m v along [axis] of particles and bodies. */
    public fun momentum(axis: Int): Double = sums[PARTICLES + MOMENTUM + axis] + sums[BODIES + MOMENTUM + axis]

    /** Σ m of the particles. */
    public val particleMass: Double get() = sums[PARTICLES + 1]

    /** ⟨c_a c_b⟩ of the peculiar velocities, (length/time)²: xx, yy, zz, xy, xz, yz. See [FlowFit] for the fit; valid until the next [take]. */
    public val moments: DoubleArray get() = fit.moments

    /**
     * ⟨w_a w_b⟩ likewise, w the velocity without the straight flow of the boundary's rate and without the mean: times mass and over volume the kinetic part of the
     * pressure tensor, which the energy balance of a shear flow needs. Plain sums; valid until the next [take].
     */
    public val kinetic: DoubleArray = DoubleArray(6)

    /** ⟨velocity − the boundary's flow⟩ along x, y, z; valid until the next [take]. */
    public val mean: DoubleArray = DoubleArray(3)

    /** Granular temperature ⟨c²⟩/3, (length/time)². 0 for fewer than two particles. */
    public val granularTemperature: Double get() = (fit.moments[0] + fit.moments[1] + fit.moments[2]) / 3

    /** Mean height of the particles. */
    public var centreZ: Double = 0.0
        private set

    /** √⟨(z − centre)²⟩. */
    public var scaleHeight: Double = 0.0
        private set

    /** Σ m X / Σ m, X = 4x + 2 v_y/Ω, in Hill's frame; else the mean of x. */
    public var guidingX: Double = 0.0
        private set

    /** Takes the sums of [population] as it stands, by the threads of [loop]. All are 0 for an empty one. */
    public fun take(population: Population, loop: RangeLoop = InlineLoop) {
        count = population.size
        table.gather(population, normalAxis, loop)
        places = table.count
        particlePlaces = table.from(leastBody)
        chooseReference()
        slabCount = (minOf(count, particlePlaces) / FlowFit.SPHERES_A_SLAB).coerceIn(1, FlowFit.MOST_SLABS)
        perSlab = if (table.greatest > table.least) slabCount / (table.greatest - table.least) else 0.0
        val chunkCount = (places + CHUNK - 1) / CHUNK
        if (chunks.size < chunkCount * SUMS) chunks = DoubleArray(chunkCount * SUMS)
        loop.run(chunkCount, 1, sumChunks)
        sums.fill(0.0)
        for (chunk in 0 until chunkCount) for (e in 0 until SUMS) sums[e] += chunks[chunk * SUMS + e]
        finish()
    }

    private fun chooseReference() {
        var place = 0
        while (place < particlePlaces && table.rows[place * WIDTH + MASS] == 0.0) place++
        val r = place * WIDTH
        val isThere = place < particlePlaces
        for (axis in 0..2) {
            origin[axis] = if (isThere) table.rows[r + POSITION + axis] else 0.0
            reference[axis] = if (isThere) table.rows[r + VELOCITY + axis] - rate[axis] * table.rows[r + POSITION + normalAxis] else 0.0
        }
    }

    private fun sum(chunk: Int) {
        val out = chunk * SUMS
        chunks.fill(0.0, out, out + SUMS)
        val from = chunk * CHUNK
        val end = minOf(places, from + CHUNK)
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
        chunks[out] = number.toDouble()
        chunks[out + 1] = mass
        chunks[out + ENERGY] = energy / 2
        chunks[out + MOMENTUM] = px
        chunks[out + MOMENTUM + 1] = py
        chunks[out + MOMENTUM + 2] = pz
    }

    /** Σ m w, Σ m w_a w_b, Σ m x, Σ m z, Σ m z², against the first particle. */
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
        chunks[out + SQUARES] = xx
        chunks[out + SQUARES + 1] = yy
        chunks[out + SQUARES + 2] = zz
        chunks[out + SQUARES + 3] = xy
        chunks[out + SQUARES + 4] = xz
        chunks[out + SQUARES + 5] = yz
        chunks[out + RELATIVE] = sx
        chunks[out + RELATIVE + 1] = sy
        chunks[out + RELATIVE + 2] = sz
        chunks[out + SUM_X] = x
        chunks[out + SUM_Z] = z
        chunks[out + SQUARE_Z] = height
    }

    /** Σ m y², Σ m y w_a, and by slab Σ m, Σ m y, Σ m w_a, against the first particle. */
    private fun sumAcross(from: Int, end: Int, out: Int) {
        var square = 0.0
        var sx = 0.0
        var sy = 0.0
        var sz = 0.0
        val rows = table.rows
        val sums = chunks
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
        sums[out + SLOPES] = sx
        sums[out + SLOPES + 1] = sy
        sums[out + SLOPES + 2] = sz
    }

    /** From sums against the first particle to moments around the means. */
    private fun finish() {
        val mass = particleMass
        val over = if (mass > 0) 1 / mass else 0.0
        var across = 0.0
        for (slab in 0 until slabCount) across += sums[SLABS + slab * FlowFit.SLAB_WIDTH + 1]
        val meanZ = sums[SUM_Z] * over
        for (e in 0 until 6) {
            fit.squares[e] = sums[SQUARES + e] - sums[RELATIVE + FlowFit.FIRST[e]] * sums[RELATIVE + FlowFit.SECOND[e]] * over
            kinetic[e] = fit.squares[e] * over
        }
        for (axis in 0..2) {
            fit.slopes[axis] = sums[SLOPES + axis] - across * sums[RELATIVE + axis] * over
            mean[axis] = if (mass > 0) reference[axis] + sums[RELATIVE + axis] * over else 0.0
        }
        fit.across = sums[SQUARE_ACROSS] - across * across * over
        for (slab in 0 until slabCount) centreSlab(slab * FlowFit.SLAB_WIDTH, across * over, over)
        fit.solve(sums[PARTICLES].toInt(), mass, slabCount)
        centreZ = origin[2] + meanZ
        scaleHeight = sqrt(maxOf(0.0, sums[SQUARE_Z] * over - meanZ * meanZ))
        val x = origin[0] + sums[SUM_X] * over
        guidingX = if (omega != null) 4 * x + 2 * sums[PARTICLES + MOMENTUM + 1] * over / omega else x
    }

    private fun centreSlab(s: Int, meanAcross: Double, over: Double) {
        val mass = sums[SLABS + s]
        fit.slabs[s] = mass
        fit.slabs[s + 1] = sums[SLABS + s + 1] - mass * meanAcross
        for (axis in 0..2) fit.slabs[s + 2 + axis] = sums[SLABS + s + 2 + axis] - mass * sums[RELATIVE + axis] * over
    }

    private companion object {
        /** Ids a chunk: some fifty microseconds of work. */
        const val CHUNK = 4096

        // Number, mass, energy and momentum, of particles and of bodies.
        const val ENERGY = 2
        const val MOMENTUM = 3
        const val PARTICLES = 0
        const val BODIES = 6

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
