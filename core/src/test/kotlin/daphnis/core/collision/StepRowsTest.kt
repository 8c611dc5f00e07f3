package daphnis.core.collision

import daphnis.core.Sphere
import daphnis.core.collision.StepRows.Companion.MARKS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.parallel.Pieces
import daphnis.core.population.Population
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

/** The packed copy of a step: what goes in, what happens to a row, what comes out. */
class StepRowsTest {
    /** No two numbers are equal, and all are exact. */
    private fun population(n: Int): Population {
        val p = populationOf(
            *Array(n) {
                val k = it + 1.0
                Sphere(k, k + 0.125, k + 0.25, -k, k + 0.375, k + 0.5, r = k + 0.625, m = k + 0.75)
            },
        )
        for (k in 0 until n) p.lastCollision[k] = -k - 0.875
        return p
    }

    private fun StepRows.row(slot: Int) = state.slice(slot * STRIDE until (slot + 1) * STRIDE)

    private fun StepRows.everything(slot: Int) =
        row(slot) + listOf(mass[slot], id[slot], origin[slot], rank(slot), streak(slot), lastCollision[slot])

    private fun loaded(n: Int, duration: Double = 1.0, tracks: Boolean = true) =
        StepRows().apply { load(population(n), IntArray(n) { n - 1 - it }, duration, tracks) }

    @Test
    fun `rows are taken over in the order given, at time 0, with no mark`() {
        val p = population(3)
        val rows = loaded(5)
        for (slot in 0 until 5) for (mark in 0 until MARKS) rows.marks[slot * MARKS + mark] = 9
        rows.load(p, intArrayOf(2, 0, 1), 1.0, true)
        assertEquals(3, rows.size)
        for ((slot, k) in listOf(0 to 2, 1 to 0, 2 to 1)) {
            val state = listOf(p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k], 0.0, p.radius[k])
            assertEquals(state + listOf(p.mass[k], k, k, 0, 0, p.lastCollision[k]), rows.everything(slot))
        }
    }

    @Test
    fun `arrays stay as long as the population does not grow`() {
        val rows = loaded(5)
        val state = rows.state
        for (n in listOf(5, 3, 5)) {
            rows.load(population(n), IntArray(n) { it }, 1.0, true)
            assertSame(state, rows.state) { "$n spheres" }
        }
        rows.load(population(6), IntArray(6) { it }, 1.0, true)
        assertNotEquals(state.size, rows.state.size)
    }

    @Test
    fun `a row goes along its path, and nobody else does`() {
        val rows = loaded(3)
        val others = listOf(0, 2).map { rows.everything(it) }
        // The middle one of three in reverse order: (2, 2.125, 2.25) with (−2, 2.375, 2.5).
        rows.advance(1, 0.5)
        assertEquals(listOf(1.0, 3.3125, 3.5, -2.0, 2.375, 2.5, 0.5, 2.625), rows.row(1))
        rows.advance(1, 0.75)
        assertEquals(listOf(0.5, 3.90625, 4.125), rows.row(1).take(3))
        assertEquals(others, listOf(0, 2).map { rows.everything(it) })
    }

    @Test
    fun `a streak goes on as long as time does not, by more than its resolution`() {
        val rows = loaded(3)
        val streaks = listOf(0.0, 1e-13, 0.25, 0.25, 0.25 + 5e-14, 0.25 + 3e-13).map {
            rows.advance(1, it)
            rows.streak(1)
        }
        assertEquals(listOf(1, 2, 1, 2, 3, 1), streaks)
        assertEquals(listOf(0, 0), listOf(rows.streak(0), rows.streak(2)))
    }

    @Test
    fun `a rank lasts as long as the time is the same to the last bit`() {
        val rows = loaded(3)
        rows.advance(1, 0.25)
        rows.marks[1 * MARKS] = 7
        rows.advance(1, 0.25)
        assertEquals(7, rows.rank(1))
        rows.advance(1, Math.nextUp(0.25))
        assertEquals(0, rows.rank(1))
    }

    @Test
    fun `at the end of a step every sphere is where its path leads`() {
        for (tracks in listOf(true, false)) {
            val p = population(3)
            val before = p.lastCollision.toList()
            val rows = StepRows().apply { load(p, intArrayOf(2, 0, 1), 2.0, tracks) }
            rows.state[1 * STRIDE + TIME] = 1.5
            rows.store(p, 2.0)
            assertEquals(listOf(2, 0, 1), p.id.toList())
            // (1, 1.125, 1.25) with (−1, 1.375, 1.5) for the half that is left.
            assertEquals(listOf(0.5, 1.8125, 2.0), listOf(p.x[1], p.y[1], p.z[1]))
            assertEquals(listOf(-1.0, 1.375, 1.5), listOf(p.vx[1], p.vy[1], p.vz[1]))
            assertEquals(listOf(-3.0, 9.875, 10.25), listOf(p.x[0], p.y[0], p.z[0]))
            assertEquals(listOf(1.625, 1.75), listOf(p.radius[1], p.mass[1]))
            val last = if (tracks) listOf(-4.875, -2.875, -3.875) else before
            assertEquals(last, p.lastCollision.toList()) { "tracks $tracks" }
        }
    }

    @Test
    fun `a copy of a row has all that belongs to it, however many there are`() {
        val source = loaded(200)
        for (k in source.marks.indices) source.marks[k] = k
        val copies = StepRows()
        repeat(2) {
            copies.clear()
            assertEquals(0, copies.size)
            for (k in 0 until 200) assertEquals(k, copies.take(source, 199 - k))
            assertEquals(200, copies.size)
            for (k in 0 until 200) assertEquals(source.everything(199 - k), copies.everything(k)) { "row $k" }
        }
        // The resolution of its step too: half of it later, the streak goes on.
        copies.advance(3, 5e-14)
        assertEquals(source.streak(196) + 1, copies.streak(3))
    }

    @Test
    fun `a row that is put back brings its state, and its last collision where that is kept`() {
        for (tracks in listOf(true, false)) {
            val rows = loaded(3, tracks = tracks)
            val copy = StepRows().apply { repeat(2) { take(rows, 1) } }
            copy.advance(1, 0.5)
            copy.marks[1 * MARKS] = 4
            copy.lastCollision[1] = 0.5
            val others = listOf(0, 2).map { rows.everything(it) }
            rows.put(1, copy, 1)
            assertEquals(copy.row(1), rows.row(1))
            assertEquals(listOf(4, 1), listOf(rows.rank(1), rows.streak(1)))
            assertEquals(if (tracks) 0.5 else 0.0, rows.lastCollision[1])
            assertEquals(others, listOf(0, 2).map { rows.everything(it) })
        }
    }

    @Test
    fun `a step taken over and brought to its end piece by piece is the same`() {
        val order = intArrayOf(3, 0, 4, 1, 2)
        val whole = population(5)
        val pieces = population(5)
        val rows = StepRows().apply { load(whole, order, 2.0, true) }
        val others = StepRows().apply {
            load(whole, order, 2.0, true)
            marks.fill(9)
            load(pieces, order, 2.0, true, Pieces)
        }
        for (slot in 0 until 5) assertEquals(rows.everything(slot), others.everything(slot)) { "slot $slot" }
        rows.store(whole, 2.0)
        others.store(pieces, 2.0, Pieces)
        val columns = { p: Population ->
            listOf(p.x, p.y, p.z, p.vx, p.vy, p.vz, p.radius, p.mass, p.lastCollision).map { it.toList() }
        }
        assertEquals(columns(whole), columns(pieces))
        assertEquals(order.toList(), pieces.id.toList())
    }
}
