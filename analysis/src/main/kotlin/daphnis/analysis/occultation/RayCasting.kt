package daphnis.analysis.occultation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PlaneImages
import daphnis.analysis.insitu.State
import daphnis.analysis.statistics.BlockAverage
import kotlin.math.PI
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * Light through a patch: parallel rays at an elevation above the ring plane, on a regular grid of points of the plane,
 * each blocked by the spheres it meets, images included. Blocked rays are found by shadows: a sphere at height z
 * shadows the ellipse around (x, y) − z/tan B · (cos A, sin A), with semi-axes r and r / sin B, of the plane.
 *
 * @param elevation B, angle between the rays and the ring plane in radians, in [[LineOfSight.LOWEST] degrees, π/2]
 * @param azimuth A, direction in the plane in which the rays climb, from x toward y, in radians
 * @param rays rays along the longer edge of the patch, at most; rays along x and y are as far apart
 */
public class RayCasting @JvmOverloads constructor(
    public val elevation: Double,
    public val azimuth: Double = 0.0,
    private val rays: Int = 1024,
) {
    init {
        LineOfSight.requireElevation(elevation)
        require(azimuth.isFinite()) { "azimuth is $azimuth; it must be finite" }
        require(rays >= 1) { "$rays rays; there must be one at least" }
    }

    /**
     * Which rays get through, by cell of the plane.
     *
     * @property nx rays along x; [ny] along y; [blocked] at `i · ny + j`
     */
    public class Shadow internal constructor(public val nx: Int, public val ny: Int) {
        public val blocked: BooleanArray = BooleanArray(nx * ny)

        /** How many times a ray was found in a shadow: what the shadows have cost. */
        internal var asked: Long = 0L

        /** Share of the rays that get through, by position along x: a synthetic occultation scan. */
        public fun scan(): DoubleArray = DoubleArray(nx) { free(it * ny, (it + 1) * ny) / ny.toDouble() }

        /** Share of all rays that get through. */
        public val transmission: Double get() = free(0, blocked.size) / blocked.size.toDouble()

        private fun free(from: Int, end: Int): Int {
            var count = 0
            for (k in from until end) if (!blocked[k]) count++
            return count
        }
    }

    /** Casts the rays through [state]. */
    public fun cast(state: State): Shadow {
        val shadow = Shadow(count(state, 0), count(state, 1))
        val caster = Caster(state, shadow, null)
        for (k in 0 until state.population.size) {
            // At low elevations few spheres leave no ray free, each by a shadow many boxes long.
            if (caster.free == 0) break
            caster.drop(k)
        }
        return shadow
    }

    /** Casts the same rays through [state], and finds what each of those that [cast] blocks meets first. */
    internal fun hits(state: State): FirstHits {
        val shadow = Shadow(count(state, 0), count(state, 1))
        val hits = FirstHits(shadow.nx, shadow.ny)
        val caster = Caster(state, shadow, hits)
        for (k in 0 until state.population.size) caster.drop(k)
        return hits
    }

    /** Rays along [axis]. */
    private fun count(state: State, axis: Int): Int {
        val box = state.boundary.box
        return maxOf(1, Math.rint(rays * box.length(axis) / maxOf(box.length(0), box.length(1))).toInt())
    }

    /** Share of the rays that get through, one number, as a [Measure]. */
    public fun transmission(): Measure = Measure { state -> doubleArrayOf(cast(state).transmission) }

    /**
     * Normal optical depth −sin B · ln T of a [transmission] that is already averaged. The logarithm of the average is
     * finite even if one of the states lets nothing through; the average of logarithms is not. The error is sin B · ΔT
     * / T. If nothing gets through, the depth is +∞ and the error NaN.
     */
    public fun depth(transmission: BlockAverage): BlockAverage {
        val t = transmission.mean
        val sine = StrictMath.sin(elevation)
        val error = if (t > 0) sine * transmission.error / t else Double.NaN
        return BlockAverage(-sine * ln(t), error, transmission.count, transmission.independent)
    }

    /**
     * Drops shadows, and into [hits], if there are any, where rays meet the spheres. Axes are those of [PlaneImages]: a
     * from row to row of images, b along a row.
     */
    private inner class Caster(state: State, private val shadow: Shadow, private val hits: FirstHits?) {
        private val population = state.population
        private val images = PlaneImages(state.boundary, state.time)
        private val isRadial = images.across == 0
        private val lowA = state.boundary.box.lower(images.across)
        private val lowB = state.boundary.box.lower(images.along)
        private val countA = if (isRadial) shadow.nx else shadow.ny
        private val countB = if (isRadial) shadow.ny else shadow.nx
        private val strideA = if (isRadial) shadow.ny else 1
        private val strideB = if (isRadial) 1 else shadow.ny
        private val stepA = state.boundary.box.length(images.across) / countA
        private val stepB = state.boundary.box.length(images.along) / countB
        private val wrapsA = images.repeats(images.across)
        private val wrapsB = images.repeats(images.along)

        // The same on every machine.
        private val towardA = if (isRadial) StrictMath.cos(azimuth) else StrictMath.sin(azimuth)
        private val towardB = if (isRadial) StrictMath.sin(azimuth) else StrictMath.cos(azimuth)
        private val sine = StrictMath.sin(elevation)
        private val cotangent = if (elevation == PI / 2) 0.0 else 1 / StrictMath.tan(elevation)
        private val toEye = LineOfSight.direction(elevation, azimuth)

        /** Rays that nothing has stopped yet. */
        var free = shadow.blocked.size
            private set

        fun drop(sphere: Int) {
            val x = population.x[sphere]
            val y = population.y[sphere]
            val z = population.z[sphere]
            val r = population.radius[sphere]
            val centreA = (if (isRadial) x else y) - z * cotangent * towardA
            val centreB = (if (isRadial) y else x) - z * cotangent * towardB
            val long = r / sine
            // Rays go through the middles of cells.
            for (i in first(centreA - long, lowA, stepA)..last(centreA + long, lowA, stepA)) {
                val row = Math.floorDiv(i, countA)
                if (row != 0 && !wrapsA) continue
                // A shadow on row m of images is, in the box, the shadow of the image at −m.
                val place = centreB - row * images.offset
                dropLine(sphere, i - row * countA, lowA + (i + 0.5) * stepA - centreA, place, long, r)
            }
        }

        /**
         * Blocks the rays at index [i] along a, which pass the centre of the shadow at the distance [pa]; [centreB] is
         * the centre along b.
         */
        private fun dropLine(sphere: Int, i: Int, pa: Double, centreB: Double, long: Double, r: Double) {
            // The shadow is convex: all rays between the first and the last that it stops.
            // Both are where a quadratic has its roots, to a ray: those before and behind are asked as well.
            val bend = towardB * towardB / (long * long) + towardA * towardA / (r * r)
            val middle = pa * towardA * towardB * (1 / (r * r) - 1 / (long * long)) / bend
            val aside = pa * pa * (towardA * towardA / (long * long) + towardB * towardB / (r * r))
            val half = sqrt(maxOf(0.0, middle * middle + (1 - aside) / bend))
            var from = first(centreB + middle - half, lowB, stepB) - 1
            var to = last(centreB + middle + half, lowB, stepB) + 1
            while (from <= to && !isWithin(pa, from, centreB, long, r)) from++
            while (to > from && !isWithin(pa, to, centreB, long, r)) to--
            if (!wrapsB) {
                from = maxOf(from, 0)
                to = minOf(to, countB - 1)
            }
            if (hits != null) {
                for (j in from..to) {
                    offer(
                        hits,
                        sphere,
                        i * strideA + Math.floorMod(j, countB) * strideB,
                        pa,
                        j,
                        centreB,
                    )
                }
            }
            if (wrapsB) to = minOf(to, from + countB - 1)
            var j = from
            while (j <= to) {
                // In one box of images.
                val start = Math.floorMod(j, countB)
                val end = minOf(countB, start + to - j + 1)
                shadow.asked += end - start
                for (k in start until end) {
                    val ray = i * strideA + k * strideB
                    if (shadow.blocked[ray]) continue
                    shadow.blocked[ray] = true
                    free--
                }
                j += end - start
            }
        }

        /** Tells [hits] of a [ray], which passes the centre at [pa] along a and at the index [j] along b. */
        private fun offer(hits: FirstHits, sphere: Int, ray: Int, pa: Double, j: Int, centreB: Double) {
            val pb = lowB + (j + 0.5) * stepB - centreB
            val dx = if (isRadial) pa else pb
            val dy = if (isRadial) pb else pa
            hits.offer(ray, sphere, dx, dy, population.z[sphere], population.radius[sphere], toEye)
        }

        private fun isWithin(pa: Double, j: Int, centreB: Double, long: Double, r: Double): Boolean {
            val pb = lowB + (j + 0.5) * stepB - centreB
            val along = (pa * towardA + pb * towardB) / long
            val beside = (pb * towardA - pa * towardB) / r
            return along * along + beside * beside <= 1
        }

        private fun first(from: Double, low: Double, step: Double) = ceil((from - low) / step - 0.5).toInt()

        private fun last(to: Double, low: Double, step: Double) = floor((to - low) / step - 0.5).toInt()
    }
}
