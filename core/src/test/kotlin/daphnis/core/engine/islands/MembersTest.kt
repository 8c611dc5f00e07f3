package daphnis.core.engine.islands

import daphnis.core.Sphere
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
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
    fun `an attempt has what came between its beginning and the next one's, beyond the first room`() {
        val attempts = Attempts()
        repeat(2) {
            val counted = CollisionCounters().apply { collisions = 5_000_000_000 }
            for (k in 0 until 600) {
                assertEquals(k, attempts.begin(rows = 3 * k, record = 2 * k, counted))
                counted.collisions += 2
                counted.wallCollisions++
                counted.guardActivations += 3
            }
            attempts.end(rows = 1799, record = 1198, counted)
            for (k in 0 until 599) {
                assertEquals(3 * k to 3 * k + 3, attempts.firstRow(k) to attempts.endOfRows(k))
                assertEquals(2 * k to 2 * k + 2, attempts.firstRecord(k) to attempts.endOfRecord(k))
            }
            assertEquals(1797 to 1799, attempts.firstRow(599) to attempts.endOfRows(599))
            assertEquals(1198 to 1198, attempts.firstRecord(599) to attempts.endOfRecord(599))
            for (k in 0 until 600 step 3) attempts.drop(k)
            for (k in 0 until 600) assertEquals(k % 3 != 0, attempts.isAlive(k))
            val alive = CollisionCounters().also { attempts.addTo(it) }
            assertEquals(listOf(800L, 400L, 1200L), alive.run { listOf(collisions, wallCollisions, guardActivations) })
            attempts.clear()
        }
    }
}
