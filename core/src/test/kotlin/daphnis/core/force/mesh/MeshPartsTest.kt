package daphnis.core.force.mesh

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

class MeshPartsTest {
    @Test
    fun `a batch of transforms is the plain sum, and back again, whatever is beside a column`() {
        val random = SeededRandom(4)
        for (n in listOf(2, 6, 8, 12, 16, 36, 48, 54)) {
            val width = 3
            val re = DoubleArray(n * width) { random.nextDouble() }
            val im = DoubleArray(n * width) { random.nextDouble() }
            val transform = BatchTransform(n)
            val rows = rowsOf(re, im)
            val found = transform.forward(rows, ComplexRows(), width)
            for (column in 0 until width) {
                for (k in 0 until n) {
                    var sumRe = 0.0
                    var sumIm = 0.0
                    for (j in 0 until n) {
                        val c = cos(2 * PI * j * k / n)
                        val s = -sin(2 * PI * j * k / n)
                        sumRe += re[j * width + column] * c - im[j * width + column] * s
                        sumIm += re[j * width + column] * s + im[j * width + column] * c
                    }
                    assertEquals(sumRe, found.re[k * width + column], 1e-12 * n) { "length $n, wave $k" }
                    assertEquals(sumIm, found.im[k * width + column], 1e-12 * n) { "length $n, wave $k" }
                }
            }
            val alone = transform.forward(
                rowsOf(
                    DoubleArray(n) {
                        re[it * width]
                    },
                    DoubleArray(n) { im[it * width] },
                ),
                ComplexRows(),
                1,
            )
            for (k in 0 until n) assertEquals(found.re[k * width], alone.re[k])
            val back = transform.backward(found, ComplexRows(), width)
            for (p in re.indices) assertEquals(n * re[p], back.re[p], 1e-12 * n)
            for (p in im.indices) assertEquals(n * im[p], back.im[p], 1e-12 * n)
        }
        assertThrows(IllegalArgumentException::class.java) { BatchTransform(10) }
    }

    private fun rowsOf(re: DoubleArray, im: DoubleArray) = ComplexRows().also {
        it.ensure(re.size)
        re.copyInto(it.re)
        im.copyInto(it.im)
    }

    @Test
    fun `lengths are the least even products of twos and threes`() {
        assertEquals(
            listOf(2, 4, 6, 6, 8, 8, 12, 18, 24, 96, 108, 1024, 1152),
            listOf(1, 3, 5, 6, 7, 8, 9, 17, 23, 82, 97, 1000, 1025).map { BatchTransform.lengthFrom(it.toDouble()) },
        )
    }

    @Test
    fun `a cloud ends as a point does, its force is the slope of its potential, its transform that of its mass`() {
        assertEquals(1.0, CompactShape.pull(1.0), 1e-14)
        assertEquals(1.0, CompactShape.depth(1.0), 1e-14)
        for (u in listOf(0.1, 0.4, 0.9)) {
            val h = 1e-6
            val slope = (CompactShape.depth((u + h) * (u + h)) - CompactShape.depth((u - h) * (u - h))) / (2 * h)
            assertEquals(CompactShape.pull(u * u) * u, -slope, 1e-8)
        }
        val shape = CompactShape(2.0)
        for (k in listOf(0.0, 0.3, 1.9, 2.1, 5.0)) {
            // ∫ 4πr² ρ sin(kr)/(kr) dr by the middles of 20,000 shells.
            var sum = 0.0
            val shells = 20_000
            for (s in 0 until shells) {
                val u = (s + 0.5) / shells
                val r = 2 * u
                val density = 315 / (64 * PI * 8) * (1 - u * u) * (1 - u * u) * (1 - u * u)
                sum += 4 * PI * r * r * density * (if (k == 0.0) 1.0 else sin(k * r) / (k * r)) * 2 / shells
            }
            assertEquals(sum, shape.transform(k), 1e-8) { "wave number $k" }
        }
    }

    @Test
    fun `weights are a partition of one with the place as their mean, and slopes are their slopes`() {
        val w = DoubleArray(4)
        val next = DoubleArray(4)
        val g = DoubleArray(4)
        for (t in listOf(0.0, 0.2, 0.7, 1.0)) {
            CubicSpline.weights(t, w, 0)
            assertEquals(1.0, w.sum(), 1e-15)
            assertEquals(t, (0..3).sumOf { (it - 1) * w[it] }, 1e-15)
            CubicSpline.slopes(t, g, 0)
            CubicSpline.weights(t + 1e-7, next, 0)
            for (a in 0..3) assertEquals((next[a] - w[a]) / 1e-7, g[a], 1e-6)
        }
        assertEquals(1.0, CubicSpline.correction(0.0))
        assertTrue(CubicSpline.correction(2.0) > 1.0)
    }
}
