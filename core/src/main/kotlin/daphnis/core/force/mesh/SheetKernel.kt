package daphnis.core.force.mesh

import kotlin.math.ceil
import kotlin.math.sqrt

/**
 * How much a plane of the mesh adds to the potential of another, for a wave number in the plane: the transform of the
 * potential of [CompactShape] clouds along x and y, with what corrects the weights along z. A thin sheet without a
 * cloud has (2π/k) e^(−kz) (Toomre 1964, ApJ 139, 1217). The rest decays within the cloud, is smooth in k, and comes
 * from a table. So does e^(−kh) of the spacing h along z.
 *
 * @param largest the greatest wave number that is asked for
 * @param spacing h of the planes along z
 * @param planes how many planes the mesh has
 */
internal class SheetKernel(shape: CompactShape, largest: Double, private val spacing: Double, val planes: Int) {
    private val rows = ceil(largest * shape.radius / STEP).toInt() + 3
    private val step = STEP / shape.radius
    private val width = planes + 1
    private val table = DoubleArray(rows * width)

    init {
        val cosines = DoubleArray(4 * SAMPLES) { StrictMath.cos(Math.PI * it / (2 * SAMPLES)) }
        val corrections = DoubleArray(SAMPLES) { CubicSpline.correction(angle(it)) }
        val differences = DoubleArray(SAMPLES)
        for (row in 0 until rows) {
            val k = row * step
            val fall = StrictMath.exp(-k * spacing)
            table[row * width] = fall
            for (m in 0 until SAMPLES) {
                val cosine = cosines[2 * m + 1]
                // Σ over planes of (2π/k) e^(−k|z|) e^(−iθz/h)
                val thin = if (row == 0) {
                    2 * Math.PI * spacing / (1 - cosine)
                } else {
                    2 * Math.PI / k * (1 - fall * fall) / (1 + fall * fall - 2 * fall * cosine)
                }
                val kz = angle(m) / spacing
                val k2 = k * k + kz * kz
                val cloud = 4 * Math.PI * shape.transform(sqrt(k2)) / (k2 * spacing)
                differences[m] = cloud * corrections[m] - thin
            }
            for (apart in 0 until planes) {
                var sum = 0.0
                for (m in 0 until SAMPLES) {
                    sum += differences[m] * cosines[((2 * m + 1) * apart) % (4 * SAMPLES)]
                }
                table[row * width + 1 + apart] = sum / SAMPLES
            }
        }
    }

    /** Writes to [into] the potential by planes apart, at wave number [k]; without the constant of k = 0. */
    fun write(k: Double, into: DoubleArray) {
        val place = k / step
        val row = place.toInt()
        val part = place - row
        val p = row * width
        val q = p + width
        if (k == 0.0) {
            for (apart in 0 until planes) into[apart] = table[p + 1 + apart] - 2 * Math.PI * spacing * apart
            return
        }
        val fall = (1 - part) * table[p] + part * table[q]
        var thin = 2 * Math.PI / k
        for (apart in 0 until planes) {
            into[apart] = thin + (1 - part) * table[p + 1 + apart] + part * table[q + 1 + apart]
            thin *= fall
        }
    }

    /** The same for the derivative by k, at k > 0. */
    fun writeSlope(k: Double, into: DoubleArray) {
        val place = k / step
        val row = place.toInt()
        val part = place - row
        val fall = StrictMath.exp(-k * spacing)
        var thin = 2 * Math.PI / k
        for (apart in 0 until planes) {
            val here = slope(row, apart)
            into[apart] = (1 - part) * here + part * slope(row + 1, apart) - thin * (1 / k + apart * spacing)
            thin *= fall
        }
    }

    private fun slope(row: Int, apart: Int): Double {
        val before = maxOf(row - 1, 0)
        val after = minOf(row + 1, rows - 1)
        return (table[after * width + 1 + apart] - table[before * width + 1 + apart]) / ((after - before) * step)
    }

    private fun angle(m: Int) = Math.PI * (m + 0.5) / SAMPLES

    private companion object {
        /** Between two rows of the table, in units of 1/a. */
        const val STEP = 0.02

        /** Angles over which a plane's share is averaged: planes further apart than twice as many are none. */
        const val SAMPLES = 64
    }
}
