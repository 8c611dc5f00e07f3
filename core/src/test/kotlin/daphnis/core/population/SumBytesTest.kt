package daphnis.core.population

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import java.nio.ByteBuffer

/** Exact sums, and what holds them, as bytes. */
class SumBytesTest {
    private fun bytes(most: Int, write: (ByteBuffer) -> Unit): ByteBuffer = ByteBuffer.allocate(most).also(write).flip()

    private fun bytes(sum: ExactSum) = bytes(ExactSum.MOST_BYTES, sum::write)

    private fun read(bytes: ByteBuffer) = ExactSum().apply { read(bytes) }

    @ParameterizedTest
    @EnumSource
    fun `a sum that is read is the one that was written, and goes on as it`(kind: ExactSumTest.Terms) {
        for (seed in 0L until 40) {
            val random = SeededRandom(seed)
            val sum = ExactSum()
            repeat(random.nextInt(300)) { sum.add(kind.draw(random)) }
            val written = bytes(sum)
            val again = read(written)
            assertEquals(0, written.remaining())
            assertEquals(sum.value().toRawBits(), again.value().toRawBits()) { "$kind, seed $seed" }
            assertEquals(sum.parts(), again.parts())
            repeat(2000) {
                val term = kind.draw(random)
                sum.add(term)
                again.add(term)
            }
            assertEquals(sum.value().toRawBits(), again.value().toRawBits()) { "$kind, seed $seed, later" }
        }
    }

    @Test
    fun `infinities and NaN are written too, and nothing is few bytes`() {
        for (special in listOf(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NaN)) {
            val sum = ExactSum().apply { addAll(doubleArrayOf(1.0, special)) }
            assertEquals(special, read(bytes(sum)).value())
        }
        assertEquals(10, bytes(ExactSum()).remaining())
        assertEquals(0.0, read(bytes(ExactSum())).value())
        val reused = ExactSum().apply { addAll(doubleArrayOf(3.0, Double.NaN)) }
        reused.read(bytes(ExactSum().apply { add(-2.5) }))
        assertEquals(-2.5, reused.value())
    }

    @Test
    fun `sums up to 2^45 times the largest number are written, greater ones are refused`() {
        val sum = ExactSum().apply { add(-Double.MAX_VALUE) }
        repeat(45) { sum.add(sum) }
        val again = read(bytes(sum))
        repeat(45) { again.add(ExactSum().apply { add(Double.MAX_VALUE) }) }
        assertEquals(Double.NEGATIVE_INFINITY, again.value())
        sum.add(sum)
        assertThrows(IllegalStateException::class.java) { bytes(sum) }
    }

    @Test
    fun `bytes that would leave no room for merging are refused, and so are a plain number and places out of order`() {
        fun bytes(special: Double, first: Int, end: Int) =
            ByteBuffer.allocate(400).putDouble(special).put(first.toByte()).put(end.toByte()).position(0)
        assertEquals(0.0, read(bytes(0.0, 0, 67)).value())
        for ((first, end) in listOf(0 to 68, 67 to 68, 5 to 5, 6 to 5, -1 to 3, 68 to 1, 0 to -1, 67 to 0)) {
            assertThrows(IllegalArgumentException::class.java, { read(bytes(0.0, first, end)) }, "$first to $end")
        }
        assertThrows(IllegalArgumentException::class.java) { read(bytes(1.0, 68, 0)) }
        val infinite = ExactSum()
        assertThrows(IllegalArgumentException::class.java) { infinite.read(bytes(Double.NaN, 5, 5)) }
        assertEquals(0.0, infinite.value())
    }

    /** Damages [bytes] and reads them with [read]; what is read must bear [use]. */
    private fun damage(bytes: ByteArray, read: (ByteBuffer) -> Unit, use: () -> Unit): Int {
        var refused = 0
        fun attempt(damaged: ByteArray, story: String) {
            try {
                read(ByteBuffer.wrap(damaged))
            } catch (e: IllegalArgumentException) {
                assertTrue(e.message!!.isNotEmpty())
                refused++
            } catch (e: RuntimeException) {
                throw AssertionError("$story: $e", e)
            }
            use()
        }
        for (size in bytes.indices step maxOf(1, bytes.size / 100)) {
            val before = refused
            attempt(bytes.copyOf(size), "the first $size")
            assertEquals(before + 1, refused) { "the first $size of ${bytes.size} bytes are read" }
        }
        val random = SeededRandom(3)
        repeat(3000) { round ->
            val damaged = bytes.copyOf()
            repeat(1 + random.nextInt(4)) { damaged[random.nextInt(bytes.size)] = random.nextInt(256).toByte() }
            attempt(damaged, "round $round")
        }
        repeat(300) { round ->
            attempt(ByteArray(bytes.size) { random.nextInt(256).toByte() }, "random bytes, round $round")
        }
        return refused
    }

    @Test
    fun `damaged bytes of a sum are refused or give another sum, and never break it`() {
        val sum = ExactSum().apply { addAll(doubleArrayOf(1e300, -3.0, 5e-300)) }
        val total = ExactSum()
        val refused = damage(bytes(sum).run { ByteArray(remaining()).also { get(it) } }, { sum.read(it) }) {
            val value = sum.value()
            total.add(sum)
            total.value()
            sum.add(-1.0)
            sum.parts()
            bytes(sum)
            if (value.isFinite()) sum.clear()
        }
        assertTrue(refused in 100..3000) { "$refused" }
    }

    @Test
    fun `damaged bytes of moments and means are refused, or give others that can be worked with`() {
        val flow = MeanFlow(normalAxis = 0, flowAxis = 1, rate = -1.5)
        val p = SumCases.gas(500, 2)
        val first = FirstMoments(0, 480).apply { add(p, 0, 500) }
        val means = Means().apply { setSlabs(500, p.x.min(), p.x.max()) }
        val central = CentralMoments(flow, 480).apply {
            clear(means)
            add(p, 0, 500)
        }
        fun array(buffer: ByteBuffer) = ByteArray(buffer.remaining()).also { buffer.get(it) }
        val read = FirstMoments(0, 480)
        val sums = FirstMoments(0, 480)
        damage(array(bytes(FirstMoments.MOST_BYTES, first::write)), { read.read(it) }) {
            sums.merge(read)
            assertTrue(read.count in 0..read.spheres)
            sums.kineticEnergy
        }
        val other = CentralMoments(flow, 480)
        val fit = FlowFit(1)
        damage(array(bytes(CentralMoments.MOST_BYTES, central::write)), { other.read(means, it) }) {
            central.merge(other)
            central.fill(fit)
        }
        val meansRead = Means()
        damage(array(bytes(Means.BYTES, means::write)), { meansRead.read(it) }) {
            other.clear(meansRead)
            other.add(p, 0, 500)
            other.fill(fit)
            fit.solve(480, 1.0, meansRead.slabCount)
        }
    }
}
