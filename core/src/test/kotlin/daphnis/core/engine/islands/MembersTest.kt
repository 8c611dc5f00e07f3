package daphnis.core.engine.islands

import daphnis.core.Sphere
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What one worker keeps of its islands: members with their paths, and attempts. */
class MembersTest {
    private val n = 1000
    private val rows = StepRows().apply {
        load(populationOf(*Array(n) { Sphere(x = 3.0 * it, vx = it * 1.0) }), IntArray(n) { it }, 1.0, false)
        for (slot in 0 until n) state[slot * STRIDE + TIME] = 1e-3 * slot
    }

    @Test
    fun `members are copies in the order of their coming, beyond the first room`() {
        val members = Members().apply { clear(IslandLimits(n)) }
        for (k in 0 until n) assertEquals(k, members.take(rows, n - 1 - k))
        for (k in 0 until n) {
            assertEquals(n - 1 - k, members.slot(k))
            assertEquals(rows.state[members.slot(k) * STRIDE], members.rows.state[k * STRIDE])
            assertEquals(PathLog.NONE, members.older(k))
        }
        members.clear(IslandLimits(n))
        assertEquals(0, members.size)
    }

    @Test
    fun `paths go from the newest piece to the one that the sphere came with`() {
        val members = Members().apply { clear(IslandLimits(n)) }
        for (k in 0 until 10) members.take(rows, 100 + k)
        for (time in 1..50) {
            for (k in 0 until 10) {
                members.leaveBehind(k)
                members.rows.state[k * STRIDE + TIME] = 1.0 + time * (k + 1)
            }
        }
        for (k in 0 until 10) {
            var piece = members.older(k)
            for (time in 49 downTo 1) {
                assertEquals(1.0 + time * (k + 1), members.paths.rows()[PathLog.offset(piece) + TIME])
                piece = members.paths.older(piece)
            }
            assertEquals(1e-3 * (100 + k), members.paths.rows()[PathLog.offset(piece) + TIME])
            assertEquals(PathLog.NONE, members.paths.older(piece))
            assertEquals(1e-3 * (100 + k), members.firstTime(k))
        }
    }

    @Test
    fun `a member that has not collided came with the time it has`() {
        val members = Members().apply { clear(IslandLimits(n)) }
        members.take(rows, 7)
        assertEquals(7e-3, members.firstTime(0))
    }

    @Test
    fun `attempts keep their counts and where they begin, and begin at nothing after they were forgotten`() {
        val attempts = Attempts()
        repeat(2) {
            for (k in 0 until 600) {
                assertEquals(k, attempts.begin(rows = 3 * k, record = 2 * k))
                repeat(k % 4) { attempts.count(k, Attempts.COLLISIONS) }
                if (k % 3 == 0) attempts.count(k, Attempts.WALL_COLLISIONS)
                if (k % 7 == 0) attempts.drop(k)
            }
            for (k in 0 until 600) {
                assertEquals(3 * k to 2 * k, attempts.firstRow(k) to attempts.firstRecord(k))
                assertEquals(k % 4, attempts.counted(k, Attempts.COLLISIONS))
                assertEquals(if (k % 3 == 0) 1 else 0, attempts.counted(k, Attempts.WALL_COLLISIONS))
                assertEquals(0, attempts.counted(k, Attempts.GUARDED))
                if (k % 7 == 0) assertFalse(attempts.isAlive(k)) else assertTrue(attempts.isAlive(k))
            }
            attempts.clear()
        }
    }

    @Test
    fun `rows and collisions of an attempt end where those of the next begin`() {
        val stores = WorkerStores().apply { prepare(1.0, IslandLimits(n)) }
        for (attempt in 0..2) {
            stores.attempts.begin(stores.members.size, stores.tried.size)
            repeat(2 + attempt) { stores.members.take(rows, it) }
        }
        assertEquals(listOf(0 to 2, 2 to 5, 5 to 9), List(3) { stores.attempts.firstRow(it) to stores.endOfRows(it) })
        assertEquals(listOf(0, 0, 0), List(3) { stores.endOfRecord(it) })
    }
}
