package daphnis.analysis.correlation

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin

/**
 * The wave that dominates the surface density of a patch, such as its wakes: the wave vector k at which the power
 * spectrum of the mean autocorrelation is largest. Crests lie across k. Errors are one standard error over the states,
 * from the jackknife: the pattern is found again without each of the states. States count for as many independent ones
 * as the correlation of their maps in time leaves.
 *
 * @property pitch angle in radians between the orbit (y) and the crests, atan(k_y/k_x), in (−π/2, π/2); trailing
 *   crests, which lean backward outward, positive
 * @property spacing of the crests along x, 2π/k_x
 * @property contrast power at k over the median of all directions at the same |k|
 */
public class WavePattern private constructor(
    public val pitch: BlockAverage,
    public val spacing: BlockAverage,
    public val contrast: Double,
) {
    public companion object {
        /**
         * The pattern in autocorrelations of [SurfaceMap], one of each state in order of time, of lags up to [lagX] and
         * [lagY] cells of [dx] × [dy]; null when no wave stands out. A wave must fit at least 1.5 times into twice the
         * largest lag along x, and be at least four cells long, because shorter ones are the packing of spheres. If the
         * highest power is in another wave, such as one along the orbit, there is no pattern. A wave stands out when
         * its [contrast] is at least [LEAST_CONTRAST], and above 1 by [LEAST_SIGNIFICANCE] times the scatter of the
         * mean spectrum itself. Counting noise and round clumps reach this in fewer than 1 of 100 patches, even with a
         * single state. More states lower the bound only as far as they differ: states with the same noise do not
         * reduce its scatter.
         */
        @JvmStatic
        public fun of(maps: List<DoubleArray>, lagX: Int, lagY: Int, dx: Double, dy: Double): WavePattern? {
            if (maps.isEmpty() || lagX < FEWEST_LAGS || lagY < FEWEST_LAGS) return null
            val size = (2 * lagX + 1) * (2 * lagY + 1)
            for (map in maps) require(map.size == size) { "a map has ${map.size} lags; it must have $size" }
            val total = DoubleArray(size)
            for (map in maps) for (k in 0 until size) total[k] += map[k]
            val all = LagSpectrum(DoubleArray(size) { total[it] / maps.size }, lagX, lagY, dx, dy)
            val samples = all.samples()
            val highest = samples.maxByOrNull { it.power } ?: return null
            if (highest.kx < FEWEST_WAVES / 2 * all.resolutionX) return null
            val peak = all.climb(doubleArrayOf(highest.kx, highest.ky)) ?: return null
            val contrast = all.power(peak[0], peak[1]) / ringMedian(all, hypot(peak[0], peak[1]))
            if (!(
                    contrast >=
                        maxOf(
                            LEAST_CONTRAST,
                            1 + LEAST_SIGNIFICANCE * scatter(samples, maxOf(all.resolutionX, all.resolutionY)),
                        )
                    )
            ) {
                return null
            }
            return withErrors(maps, total, peak, contrast) { LagSpectrum(it, lagX, lagY, dx, dy) }
        }

        private fun withErrors(
            maps: List<DoubleArray>,
            total: DoubleArray,
            peak: DoubleArray,
            contrast: Double,
            spectrum: (DoubleArray) -> LagSpectrum,
        ): WavePattern {
            val pitch = atan2(peak[1], peak[0])
            val spacing = 2 * PI / peak[0]
            val n = maps.size
            if (n < 2) {
                return WavePattern(
                    BlockAverage(pitch, Double.NaN, n),
                    BlockAverage(spacing, Double.NaN, n),
                    contrast,
                )
            }
            // k_x > 0 throughout, so no angle jumps by π. The average and error are those of the series of
            // pseudo-values n θ − (n − 1) θ₋ₖ.
            val pitches = DoubleArray(n)
            val spacings = DoubleArray(n)
            for ((k, map) in maps.withIndex()) {
                val without = spectrum(DoubleArray(total.size) { (total[it] - map[it]) / (n - 1) }).climb(peak) ?: peak
                pitches[k] = pitch + (n - 1) * (pitch - atan2(without[1], without[0]))
                spacings[k] = spacing + (n - 1) * (spacing - 2 * PI / without[0])
            }
            val states = IndependentStates(maps)
            return WavePattern(states.average(pitch, pitches), states.average(spacing, spacings), contrast)
        }

        /** Median over all directions at the wave number [k]; not below 0. */
        private fun ringMedian(spectrum: LagSpectrum, k: Double): Double = median(
            DoubleArray(DIRECTIONS) {
                val angle = PI * (it + 0.5) / DIRECTIONS
                spectrum.power(k * cos(angle), k * sin(angle))
            },
        ).coerceAtLeast(0.0)

        /**
         * One standard deviation of the noise of a spectrum over its level: how far the lower sixth of the [samples] is
         * below the median of its ring, of the given [width]. The lower side is used, because waves raise the upper
         * one.
         */
        private fun scatter(samples: List<Sample>, width: Double): Double {
            val relative = ArrayList<Double>()
            for (ring in samples.groupBy { (hypot(it.kx, it.ky) / width).toInt() }.values) {
                val level = median(DoubleArray(ring.size) { ring[it].power })
                if (ring.size >= FEWEST_OF_RING && level > 0) ring.mapTo(relative) { it.power / level }
            }
            relative.sort()
            return if (relative.isEmpty()) 1.0 else 1 - relative[relative.size / 6]
        }

        private fun median(values: DoubleArray): Double {
            values.sort()
            return (values[(values.size - 1) / 2] + values[values.size / 2]) / 2
        }

        /** See [of]. */
        public const val LEAST_CONTRAST: Double = 2.0

        /** See [of]. */
        public const val LEAST_SIGNIFICANCE: Double = 12.0
        private const val FEWEST_OF_RING = 8
        private const val FEWEST_LAGS = 6
        private const val FEWEST_WAVES = 1.5
        private const val DIRECTIONS = 72
    }
}

/** The [power] at a wave vector. */
private class Sample(val kx: Double, val ky: Double, val power: Double)

/**
 * The power spectrum of an autocorrelation at any wave vector, Σ w(l) A(l) cos(k·l), with triangular weights w along
 * both axes, which leave it positive. Lags at negative x are the mirror of the others.
 */
private class LagSpectrum(
    a: DoubleArray,
    private val lagX: Int,
    private val lagY: Int,
    private val dx: Double,
    private val dy: Double,
) {
    /** Distance in k that the largest lags tell apart. */
    val resolutionX: Double = 2 * PI / (lagX * dx)
    val resolutionY: Double = 2 * PI / (lagY * dy)

    /** A wave of four cells. */
    val largest: Double = 2 * PI / (4 * maxOf(dx, dy))

    private val width = 2 * lagY + 1

    /** Of the lag (i, j) at `i · width + j + lagY`, i ≥ 0. */
    private val weighted = DoubleArray((lagX + 1) * width) {
        val i = it / width
        val j = it % width - lagY
        (1 - i.toDouble() / lagX) * (1 - abs(j).toDouble() / lagY) * a[(i + lagX) * width + j + lagY] *
            if (i == 0) 1 else 2
    }

    // Sums of the last call of [sum]: power, gradient, second derivatives.
    private val sums = DoubleArray(6)

    private fun sum(kx: Double, ky: Double) {
        sums.fill(0.0)
        for (i in 0..lagX) {
            for (j in -lagY..lagY) {
                val x = i * dx
                val y = j * dy
                val w = weighted[i * width + j + lagY]
                val c = w * cos(kx * x + ky * y)
                val s = w * sin(kx * x + ky * y)
                sums[0] += c
                sums[1] -= s * x
                sums[2] -= s * y
                sums[3] -= c * x * x
                sums[4] -= c * x * y
                sums[5] -= c * y * y
            }
        }
    }

    fun power(kx: Double, ky: Double): Double {
        var power = 0.0
        for (i in 0..lagX) {
            for (j in -lagY..lagY) {
                power +=
                    weighted[i * width + j + lagY] * cos(kx * i * dx + ky * j * dy)
            }
        }
        return power
    }

    /**
     * The upper half of the wave vectors, k_x ≥ 0, on a grid half as fine as the spectrum is sharp, without the middle.
     */
    fun samples(): List<Sample> {
        val stepX = resolutionX / 2
        val stepY = resolutionY / 2
        val result = ArrayList<Sample>()
        for (i in 0..(largest / stepX).toInt()) {
            for (j in -(largest / stepY).toInt()..(largest / stepY).toInt()) {
                val kx = i * stepX
                val ky = j * stepY
                val k = hypot(kx, ky)
                if (k > largest || k < resolutionX / 2 || i == 0 && j <= 0) continue
                result += Sample(kx, ky, power(kx, ky))
            }
        }
        return result
    }

    /** The maximum that Newton's method reaches from [start]; null if there is none nearby, or it leaves the range. */
    fun climb(start: DoubleArray): DoubleArray? {
        var kx = start[0]
        var ky = start[1]
        repeat(STEPS) {
            sum(kx, ky)
            val determinant = sums[3] * sums[5] - sums[4] * sums[4]
            // No maximum here.
            if (!(sums[3] < 0 && determinant > 0)) return null
            val stepX = (sums[5] * sums[1] - sums[4] * sums[2]) / determinant
            val stepY = (sums[3] * sums[2] - sums[4] * sums[1]) / determinant
            kx -= stepX
            ky -= stepY
            if (abs(kx - start[0]) > resolutionX || abs(ky - start[1]) > resolutionY || kx <= resolutionX / 2) {
                return null
            }
            if (abs(stepX) < ENOUGH * resolutionX && abs(stepY) < ENOUGH * resolutionY) return doubleArrayOf(kx, ky)
        }
        return null
    }

    private companion object {
        const val STEPS = 30
        const val ENOUGH = 1e-9
    }
}
