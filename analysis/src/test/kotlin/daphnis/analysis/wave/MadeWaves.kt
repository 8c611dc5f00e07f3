package daphnis.analysis.wave

import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.sin
import kotlin.math.sqrt

/** Waves of known growth and frequency in a ring of Ω = 1 and [RADIAL_FACTOR], as rows of a mode. */
internal object MadeWaves {
    const val RADIAL_FACTOR = 0.98
    val FREQUENCIES = OrbitalFrequencies(1.0, RADIAL_FACTOR)
    val PERIOD = 2 * PI / FREQUENCIES.kappa
    const val ROWS = 16

    /**
     * @param outward complex amplitude of the wave that goes outward at a row, without its turning; [inward] likewise
     * @param noise standard deviation of noise in each part of both velocities, correlated over [memory] periods
     */
    fun of(
        periods: Int,
        frequency: Double,
        outward: (Int) -> DoubleArray,
        inward: (Int) -> DoubleArray = { doubleArrayOf(0.0, 0.0) },
        noise: Double = 0.0,
        memory: Double = 0.3,
        random: SeededRandom = SeededRandom(1),
    ): WaveAmplitudes {
        val rows = periods * ROWS + 1
        val dt = PERIOD / ROWS
        val times = DoubleArray(rows) { 3.0 + it * dt }
        val x = DoubleArray(rows) to DoubleArray(rows)
        val y = DoubleArray(rows) to DoubleArray(rows)
        val kept = exp(-1 / (memory * ROWS))
        val rest = DoubleArray(4) { noise * random.nextGaussian() }
        for (k in 0 until rows) {
            val c = cos(frequency * times[k])
            val s = sin(frequency * times[k])
            val o = outward(k).let { doubleArrayOf(it[0] * c + it[1] * s, it[1] * c - it[0] * s) }
            // The conjugate turns the other way.
            val i = inward(k).let { doubleArrayOf(it[0] * c + it[1] * s, -(it[1] * c - it[0] * s)) }
            // v_x = o + i; i f v_y = o − i.
            x.first[k] = o[0] + i[0] + rest[0]
            x.second[k] = o[1] + i[1] + rest[1]
            y.first[k] = (o[1] - i[1]) * RADIAL_FACTOR / 2 + rest[2] * RADIAL_FACTOR / 2
            y.second[k] = -(o[0] - i[0]) * RADIAL_FACTOR / 2 + rest[3] * RADIAL_FACTOR / 2
            for (j in rest.indices) {
                rest[j] = kept * rest[j] + noise * sqrt(1 - kept * kept) * random.nextGaussian()
            }
        }
        return checkNotNull(WaveAmplitudes.of(times, x, y, FREQUENCIES))
    }

    /** Growth at [rate] per period from [start], which ends at [top] as in Landau's equation. */
    fun growing(rate: Double, start: Double, top: Double, phase: Double): (Int) -> DoubleArray = { k ->
        val free = start * exp(rate * k / ROWS)
        val size = free / sqrt(1 + (free / top) * (free / top))
        doubleArrayOf(size * cos(phase), size * sin(phase))
    }

    /** The same by Landau's equation with noise of [kick] per root of a period. */
    fun driven(rate: Double, start: Double, top: Double, kick: Double, random: SeededRandom): (Int) -> DoubleArray {
        val states = ArrayList<DoubleArray>()
        states += doubleArrayOf(start, 0.0)
        return { k ->
            while (states.size <= k) {
                val (a, b) = states.last()
                val factor = exp(rate * (1 - (a * a + b * b) / (top * top)) / ROWS)
                fun next(part: Double) = part * factor + kick * random.nextGaussian() / sqrt(2.0 * ROWS)
                states += doubleArrayOf(next(a), next(b))
            }
            states[k]
        }
    }
}
