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
    private val sums = DoubleArray(FIRST_WIDTH)
    private val seconds = DoubleArray(SECOND_WIDTH)
    private val first = RangeBody { _, from, to -> for (chunk in from until to) sumFirst(chunk) }
    private val second = RangeBody { _, from, to -> for (chunk in from until to) sumSecond(chunk) }

    // Of the row at hand.
    private var places = 0
    private var particlePlaces = 0
    private var across = 0.0
    private var least = 0.0
    private var perSlab = 0.0
    private var slabCount = 0

    /** Number of spheres, bodies included. */
    public var count: Int = 0
        private set

    /** Σ m, Σ m v²/2 and Σ m v, of particles and bodies. */
    public val mass: Double get() = sums[ALL_MASS]

    /** Σ m v²/2 of particles and bodies. */
    public val kineticEnergy: Double get() = sums[ENERGY]

    /** Σ m v along [axis] of particles and bodies. */
    public fun momentum(axis: Int): Double = sums[MOMENTUM + axis]

    /** Σ m of the particles. */
    public val particleMass: Double get() = sums[PARTICLE_MASS]

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
        table.gather(population, loop)
        places = table.count
        particlePlaces = table.from(leastBody)
        val chunkCount = (places + CHUNK - 1) / CHUNK
        if (chunks.size < chunkCount * SECOND_WIDTH) chunks = DoubleArray(chunkCount * SECOND_WIDTH)
        loop.run(chunkCount, 1, first)
        addFirst(chunkCount)
        prepareSecond()
        loop.run(chunkCount, 1, second)
        add(chunkCount, SECOND_WIDTH, seconds)
        finish()
    }

    private fun sumFirst(chunk: Int) {
        val rows = table.rows
        val out = chunk * FIRST_WIDTH
        chunks.fill(0.0, out, out + FIRST_WIDTH)
        var low = Double.POSITIVE_INFINITY
        var high = Double.NEGATIVE_INFINITY
        for (place in chunk * CHUNK until minOf(places, chunk * CHUNK + CHUNK)) {
            val r = place * WIDTH
            val m = rows[r + MASS]
            if (m == 0.0) continue
            val vx = rows[r + VELOCITY]
            val vy = rows[r + VELOCITY + 1]
            val vz = rows[r + VELOCITY + 2]
            chunks[out + ALL_MASS] += m
            chunks[out + ENERGY] += 0.5 * m * (vx * vx + vy * vy + vz * vz)
            chunks[out + MOMENTUM] += m * vx
            chunks[out + MOMENTUM + 1] += m * vy
            chunks[out + MOMENTUM + 2] += m * vz
            if (place >= particlePlaces) continue
            val a = rows[r + POSITION + normalAxis]
            val x = rows[r + POSITION]
            low = Math.min(low, a)
            high = Math.max(high, a)
            chunks[out + PARTICLES]++
            chunks[out + PARTICLE_MASS] += m
            chunks[out + RELATIVE] += m * (vx - rate[0] * a)
            chunks[out + RELATIVE + 1] += m * (vy - rate[1] * a)
            chunks[out + RELATIVE + 2] += m * (vz - rate[2] * a)
            chunks[out + ACROSS] += m * a
            chunks[out + HEIGHT] += m * rows[r + POSITION + 2]
            chunks[out + GUIDING] += m * if (omega != null) 4 * x + 2 * vy / omega else x
        }
        chunks[out + LOW] = low
        chunks[out + HIGH] = high
    }

    private fun addFirst(chunkCount: Int) {
        add(chunkCount, FIRST_WIDTH, sums)
        sums[LOW] = Double.POSITIVE_INFINITY
        sums[HIGH] = Double.NEGATIVE_INFINITY
        for (chunk in 0 until chunkCount) {
            sums[LOW] = Math.min(sums[LOW], chunks[chunk * FIRST_WIDTH + LOW])
            sums[HIGH] = Math.max(sums[HIGH], chunks[chunk * FIRST_WIDTH + HIGH])
        }
    }

    private fun add(chunkCount: Int, width: Int, into: DoubleArray) {
        into.fill(0.0)
        for (chunk in 0 until chunkCount) for (e in 0 until width) into[e] += chunks[chunk * width + e]
    }

    private fun prepareSecond() {
        val mass = particleMass
        for (axis in 0..2) mean[axis] = if (mass > 0) sums[RELATIVE + axis] / mass else 0.0
        across = if (mass > 0) sums[ACROSS] / mass else 0.0
        centreZ = if (mass > 0) sums[HEIGHT] / mass else 0.0
        guidingX = if (mass > 0) sums[GUIDING] / mass else 0.0
        slabCount = (sums[PARTICLES].toInt() / FlowFit.SPHERES_A_SLAB).coerceIn(1, FlowFit.MOST_SLABS)
        least = sums[LOW]
        perSlab = if (sums[HIGH] > sums[LOW]) slabCount / (sums[HIGH] - sums[LOW]) else 0.0
    }

    private fun sumSecond(chunk: Int) {
        val rows = table.rows
        val sums = chunks
        val out = chunk * SECOND_WIDTH
        sums.fill(0.0, out, out + SECOND_WIDTH)
        val hasFlow = flow != null
        for (place in chunk * CHUNK until minOf(particlePlaces, chunk * CHUNK + CHUNK)) {
            val r = place * WIDTH
            val m = rows[r + MASS]
            if (m == 0.0) continue
            val a = rows[r + POSITION + normalAxis]
            val wx = rows[r + VELOCITY] - rate[0] * a - mean[0]
            val wy = rows[r + VELOCITY + 1] - rate[1] * a - mean[1]
            val wz = rows[r + VELOCITY + 2] - rate[2] * a - mean[2]
            val dz = rows[r + POSITION + 2] - centreZ
            sums[out] += m * wx * wx
            sums[out + 1] += m * wy * wy
            sums[out + 2] += m * wz * wz
            sums[out + 3] += m * wx * wy
            sums[out + 4] += m * wx * wz
            sums[out + 5] += m * wy * wz
            sums[out + SQUARE_Z] += m * dz * dz
            if (!hasFlow) continue
            val y = a - across
            sums[out + SQUARE_ACROSS] += m * y * y
            sums[out + SLOPES] += m * y * wx
            sums[out + SLOPES + 1] += m * y * wy
            sums[out + SLOPES + 2] += m * y * wz
            val s = out + SLABS + FlowFit.SLAB_WIDTH * minOf(slabCount - 1, ((a - least) * perSlab).toInt())
            sums[s] += m
            sums[s + 1] += m * y
            sums[s + 2] += m * wx
            sums[s + 3] += m * wy
            sums[s + 4] += m * wz
        }
    }

    private fun finish() {
        val mass = particleMass
        scaleHeight = if (mass > 0) sqrt(seconds[SQUARE_Z] / mass) else 0.0
        for (e in 0 until 6) kinetic[e] = if (mass > 0) seconds[e] / mass else 0.0
        seconds.copyInto(fit.squares, 0, 0, 6)
        fit.across = seconds[SQUARE_ACROSS]
        seconds.copyInto(fit.slopes, 0, SLOPES, SLOPES + 3)
        seconds.copyInto(fit.slabs, 0, SLABS, SECOND_WIDTH)
        fit.solve(sums[PARTICLES].toInt(), mass, slabCount)
    }

    private companion object {
        /** Ids a chunk: some twenty microseconds of work. */
        const val CHUNK = 4096

        // Sums of the first pass.
        const val ALL_MASS = 0
        const val ENERGY = 1
        const val MOMENTUM = 2
        const val PARTICLE_MASS = 5
        const val PARTICLES = 6
        const val RELATIVE = 7
        const val ACROSS = 10
        const val HEIGHT = 11
        const val GUIDING = 12
        const val LOW = 13
        const val HIGH = 14
        const val FIRST_WIDTH = 15

        // Of the second, after the six products of velocities.
        const val SQUARE_Z = 6
        const val SQUARE_ACROSS = 7
        const val SLOPES = 8
        const val SLABS = 11
        const val SECOND_WIDTH = SLABS + FlowFit.MOST_SLABS * FlowFit.SLAB_WIDTH
    }
}
