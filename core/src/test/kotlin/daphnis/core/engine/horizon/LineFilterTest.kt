package daphnis.core.engine.horizon

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.math.BigDecimal

class LineFilterTest {
    private val filters = listOfNotNull(ScalarFilter, LineFilter.vector())

    @Test
    fun `tests run with the vector unit, which then is what engines use`() {
        assertNotNull(LineFilter.vector(), "start tests with --add-modules jdk.incubator.vector")
        assertSame(LineFilter.vector()!!.javaClass, LineFilter.BEST.javaClass)
        assertTrue(HorizonEngine.usesVectorUnit)
    }

    @Test
    fun `whoever comes near in exact arithmetic is kept, and hardly anyone else`() {
        var near = 0
        val kept = IntArray(filters.size)
        for (seed in 1..DRAWS) {
            val draw = Draw(seed)
            val exact = (0 until LINES).filter { draw.comesNear(it) }
            near += exact.size
            for ((f, filter) in filters.withIndex()) {
                val found = draw.search(filter, 0, LINES)
                val missed = exact - found.toSet()
                assertTrue(missed.isEmpty()) { "seed $seed, ${filter.javaClass.simpleName}: $missed" }
                kept[f] += found.size
            }
        }
        assertTrue(near > 4 * DRAWS) { "only $near come near" }
        for (count in kept) assertTrue(count < near * MOST_TOO_MANY) { "$count kept for $near" }
    }

    @Test
    fun `whoever only just comes near is kept, at a graze or at the last moment`() {
        for ((f, filter) in filters.withIndex()) {
            val random = SeededRandom(11)
            repeat(DRAWS) {
                val state = FloatArray(Lines.BLOCK)
                val query = query()
                val time = random.nextDouble(0.5, 2.0)
                val inflation = 1e-3
                // The sum of the radii is 1.5.
                val isGraze = it % 2 == 0
                val along = if (isGraze) random.nextDouble(3.0, 6.0) else 1.5 + random.nextDouble(0.05, 0.07)
                val beside = if (isGraze) 1.5 * (1 - 1e-5) else 0.0
                val speed = if (isGraze) 2 * along / time else (along - 1.5) * (1 + 1e-5) / time
                val p = Lines.place(f)
                state[p] = along.toFloat()
                state[p + Lines.Y] = beside.toFloat()
                state[p + Lines.U] = -speed.toFloat()
                state[p + Lines.RADIUS] = 1f
                query.radius = (0.5 + inflation).toFloat()
                query.lookFrom(0.0, time)
                assertEquals(listOf(f), kept(filter, state, query, f, f + 1)) {
                    "${filter.javaClass.simpleName}: $along, $beside, $speed, $time"
                }
            }
        }
    }

    @Test
    fun `only slots of the run are told, in order, wherever it begins and ends in a block`() {
        val draw = Draw(7)
        for (filter in filters) {
            val all = draw.search(filter, 0, LINES)
            assertTrue(all.size > 3) { "$all" }
            for (first in 0..20) {
                for (end in first..LINES step 3) {
                    assertEquals(all.filter { it in first until end }, draw.search(filter, first, end)) {
                        "${filter.javaClass.simpleName}: $first until $end"
                    }
                }
            }
        }
    }

    @Test
    fun `lines of many runs are kept in the order of the runs, with room for all, until they are cleared`() {
        val state = FloatArray(4096 / 8 * Lines.BLOCK)
        for (slot in 0 until 4096) state[Lines.place(slot) + Lines.RADIUS] = 1f
        val query = query().apply {
            radius = 1f
            lookFrom(0.0, 1.0)
        }
        for (filter in filters) {
            val tight = KeptLines()
            filter.near(state, query, 0, 200, tight)
            filter.near(state, query, 200, 320, tight)
            assertEquals(
                (0 until 320).toList(),
                buildList {
                    tight.forEach { add(it) }
                },
            ) { filter.javaClass.simpleName }
            val kept = KeptLines()
            repeat(2) {
                val expected = ArrayList<Int>()
                for ((first, end) in listOf(7 to 9, 4000 to 4096, 0 to 8, 100 to 100, 15 to 16, 1 to 3000)) {
                    filter.near(state, query, first, end, kept)
                    expected += first until end
                }
                assertEquals(expected, buildList { kept.forEach { add(it) } }) { filter.javaClass.simpleName }
                kept.clear()
            }
        }
    }

    @Test
    fun `a pair that touches already is kept, whether or not it parts`() {
        for (filter in filters) {
            for (speed in listOf(-1f, 0f, 1f)) {
                val state = FloatArray(Lines.BLOCK)
                state[Lines.place(3)] = 1.5f
                state[Lines.place(3) + Lines.U] = speed
                state[Lines.place(3) + Lines.RADIUS] = 1f
                val query = query().apply {
                    radius = 1f
                    lookFrom(0.0, 1.0)
                }
                assertEquals(listOf(3), kept(filter, state, query, 3, 4)) { "${filter.javaClass.simpleName} at $speed" }
            }
        }
    }

    /** One line at rest in the middle of others, with the lengths of [EpochFrame]. */
    private class Draw(seed: Int) {
        private val random = SeededRandom(seed.toLong())
        private fun between(a: Double, b: Double) = random.nextDouble(a, b)

        private val size = Math.pow(10.0, between(0.5, 2.0))
        private val from = between(0.0, 2.0).toFloat()
        private val end = from + between(0.01, 3.0).toFloat()
        private val state = FloatArray((LINES + 7) / 8 * Lines.BLOCK)
        private val query = query()
        private val inflation: Float
        private val scale: Double

        init {
            val own = size / 2 + between(-1.0, 1.0)
            for (slot in 0 until LINES) {
                val p = Lines.place(slot)
                // Around the middle, and with speeds by which some come near only just, or only just in time.
                for (axis in 0..2) {
                    val velocity = between(-3.0, 3.0)
                    state[p + axis * 8] = (own + between(-2.5, 2.5) - velocity * from).toFloat()
                    state[p + Lines.U + axis * 8] = velocity.toFloat()
                }
                state[p + Lines.RADIUS] = between(0.2, 1.0).toFloat()
            }
            scale = 4 * (size + 12 + 3 * end)
            inflation = (8 * scale * 8 / (1 shl 23) + 1e-3).toFloat()
            query.x = own.toFloat()
            query.y = own.toFloat()
            query.z = own.toFloat()
            query.u = between(-1.0, 1.0).toFloat()
            query.v = between(-1.0, 1.0).toFloat()
            query.radius = 0.5f + inflation
            query.lookFrom(from.toDouble(), end.toDouble())
        }

        fun search(filter: LineFilter, first: Int, end: Int): List<Int> = kept(filter, state, query, first, end)

        /** Whether two spheres without inflation overlap at some time, computed without rounding. */
        fun comesNear(slot: Int): Boolean {
            val p = Lines.place(slot)
            fun exact(f: Float) = BigDecimal(f.toDouble())
            val u = List(3) { exact(state[p + Lines.U + it * 8]) - exact(listOf(query.u, query.v, query.w)[it]) }
            val d = List(3) {
                exact(state[p + it * 8]) + exact(state[p + Lines.U + it * 8]) * exact(from) -
                    exact(listOf(query.x, query.y, query.z)[it])
            }
            val s = exact(state[p + Lines.RADIUS]) + BigDecimal("0.5")
            val c = d.sumOf { it * it } - s * s
            val b = (0..2).sumOf { d[it] * u[it] }
            val a = u.sumOf { it * it }
            val time = exact(end) - exact(from)
            if (c.signum() <= 0 || c + b * time * BigDecimal(2) + a * time * time <= BigDecimal.ZERO) return true
            // Between the ends only if the least distance is reached there: 0 < -b < a * time.
            return b.signum() < 0 && -b < a * time && b * b >= a * c
        }
    }

    private companion object {
        const val DRAWS = 300
        const val LINES = 61
        const val MOST_TOO_MANY = 1.5

        fun kept(filter: LineFilter, state: FloatArray, query: LineQuery, first: Int, end: Int): List<Int> {
            val kept = KeptLines()
            filter.near(state, query, first, end, kept)
            return buildList { kept.forEach { add(it) } }
        }

        /** Of a line that rests at the origin. */
        fun query() = LineQuery(EpochFrame())
    }
}
