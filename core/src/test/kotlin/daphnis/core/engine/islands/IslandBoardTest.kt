package daphnis.core.engine.islands

import daphnis.core.Sphere
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.engine.islands.IslandBoard.Companion.FREE
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

@Timeout(60)
class IslandBoardTest {
    private fun rowsOf(n: Int) = StepRows().apply {
        load(populationOf(*Array(n) { Sphere(x = 3.0 * it) }), IntArray(n) { it }, 1.0, false)
    }

    private fun boardOf(n: Int, workers: Int = 4) = IslandBoard(rowsOf(n), workers).apply { prepare(n) }

    /** A board with one seed for each of [pairs], hung and owned. */
    private fun IslandBoard.seed(vararg pairs: Pair<Int, Int>) = apply {
        seeds.reset(pairs.size)
        for ((first, second) in pairs) {
            seeds.store.put(seeds.reserve(1), 0.5, first, second, 0)
            if (second >= 0) union(first, second)
        }
        for (s in pairs.indices) {
            val root = find(pairs[s].first)
            own(s, root)
            hang(s, root)
        }
    }

    private fun IslandBoard.seedsOf(root: Int): Set<Int> = buildSet {
        var s = firstSeed(root)
        while (s != FREE) {
            assertTrue(add(s)) { "seed $s twice in the list of $root" }
            s = seeds.store.link(s)
        }
    }

    @Test
    fun `of two claims on a sphere at once one succeeds`() {
        val board = boardOf(TURNS)
        val won = Array(2) { BooleanArray(TURNS) }
        inStep(TURNS) { worker, slot -> won[worker][slot] = board.claim(slot, worker) }
        for (slot in 0 until TURNS) {
            assertTrue(won[0][slot] != won[1][slot]) { "slot $slot" }
            assertTrue(won[board.owner(slot)][slot]) { "slot $slot" }
        }
    }

    @Test
    fun `of two unions of a sphere at once both hold`() {
        val board = boardOf(3 * TURNS)
        inStep(TURNS) { worker, turn -> board.union(3 * turn + 2, 3 * turn + worker) }
        for (slot in 0 until 3 * TURNS) assertEquals(slot - slot % 3, board.find(slot))
    }

    @Test
    fun `of two seeds hung at once both are in the list, and one was the first`() {
        val board = boardOf(TURNS)
        board.seeds.reset(2 * TURNS)
        for (s in 0 until 2 * TURNS) board.seeds.store.put(s, 0.5, s / 2, -1, 0)
        val first = Array(2) { BooleanArray(TURNS) }
        inStep(TURNS) { worker, root ->
            first[worker][root] = board.hang(2 * root + worker, root)
        }
        for (root in 0 until TURNS) {
            assertEquals(setOf(2 * root, 2 * root + 1), board.seedsOf(root))
            assertTrue(first[0][root] != first[1][root]) { "root $root" }
        }
    }

    @Test
    fun `unions from all threads at once join what they should and nothing else`() {
        val n = 1000
        val board = boardOf(n)
        FixedPool(4).use { pool ->
            repeat(100) { round ->
                board.prepare(n)
                // Classes modulo 7, joined link by link by four workers in different orders.
                pool.run { worker ->
                    for (k in 0 until n - 7) {
                        val slot = (k * 37 + worker * 251 + round) % (n - 7)
                        board.union(slot, slot + 7)
                    }
                }
                for (slot in 0 until n) assertEquals(slot % 7, board.find(slot))
            }
        }
    }

    @Test
    fun `roots, lists and owners are those of a plain partition, however seeds are drawn`() {
        for (seed in 1L..200L) {
            val random = SeededRandom(seed)
            val n = 2 + random.nextInt(40)
            val pairs = Array(random.nextInt(30)) {
                val a = random.nextInt(n)
                a to if (random.nextInt(5) == 0) -1 else (a + 1 + random.nextInt(n - 1)) % n
            }
            val board = boardOf(n).seed(*pairs)
            val label = IntArray(n) { it }
            for ((a, b) in pairs) {
                if (b < 0) continue
                val low = minOf(label[a], label[b])
                val high = maxOf(label[a], label[b])
                for (k in 0 until n) if (label[k] == high) label[k] = low
            }
            val seeded = pairs.flatMap { listOf(it.first, it.second) }.toSet()
            for (slot in 0 until n) {
                assertEquals(label[slot], board.find(slot)) { "seed $seed, slot $slot" }
                assertEquals(if (slot in seeded) label[slot] else FREE, board.owner(slot)) { "seed $seed, slot $slot" }
                val expected = pairs.indices.filter { label[pairs[it].first] == slot }.toSet()
                assertEquals(if (label[slot] == slot) expected else emptySet(), board.seedsOf(slot))
            }
        }
    }

    @Test
    fun `islands that are merged have all their seeds, and own their spheres`() {
        val board = boardOf(8).seed(0 to 1, 4 to 5, 6 to -1)
        board.union(0, 4)
        board.union(6, 5)
        for (root in listOf(0, 4, 6)) board.moveSeeds(root)
        board.ownSeeded(0)
        assertEquals(setOf(0, 1, 2), board.seedsOf(0))
        assertEquals(emptySet<Int>(), board.seedsOf(4) + board.seedsOf(6))
        assertEquals(listOf(0, 0, FREE, FREE, 0, 0, 0, FREE), List(8) { board.owner(it) })
    }

    @Test
    fun `a sphere taken and given back is as before, and one with seeds stays claimed`() {
        val rows = rowsOf(4)
        val board = IslandBoard(rows, 3).apply { prepare(4) }.seed(0 to 1)
        rows.state[2 * STRIDE + TIME] = 0.25
        assertTrue(board.claim(2, 0))
        assertFalse(board.claim(2, 3))
        val attempt = board.attemptNumber(2, 5)
        assertEquals(2 to 5, board.workerOf(attempt) to board.indexOf(attempt))
        for (slot in 0..2) {
            board.take(slot, 0, attempt, 10 + slot)
            assertTrue(rows.state[slot * STRIDE + TIME].isNaN())
            assertEquals(attempt to 10 + slot, board.attempt(slot) to board.place(slot))
        }
        for (slot in 0..2) board.giveBack(slot, if (slot == 2) 0.25 else 0.0)
        assertEquals(listOf(0.0, 0.0, 0.25, 0.0), List(4) { rows.state[it * STRIDE + TIME] })
        assertEquals(listOf(0, 0, FREE, FREE), List(4) { board.owner(it) })
        assertEquals(listOf(0, 0, 0, 0), List(4) { board.attempt(it) })
    }

    @Test
    fun `after a step that failed all slots are free again, after one that was committed they are already`() {
        val board = boardOf(6).seed(0 to 1, 3 to 4)
        board.claim(5, 0)
        board.prepare(6)
        for (slot in 0 until 6) {
            assertEquals(
                listOf(slot, FREE, 0, FREE),
                board.run {
                    listOf(find(slot), owner(slot), attempt(slot), place(slot))
                },
            )
            assertEquals(FREE, board.firstSeed(slot))
        }
        board.seed(2 to 3)
        val attempt = board.attemptNumber(1, 0)
        for (slot in 2..3) board.take(slot, 2, attempt, slot)
        for (slot in 2..3) board.release(slot, 1)
        board.leaveClean()
        for (slot in 0 until 6) {
            assertEquals(
                listOf(slot, FREE, 0, FREE),
                board.run {
                    listOf(find(slot), owner(slot), attempt(slot), place(slot))
                },
            )
        }
    }

    @Test
    fun `who writes what belongs to another is noticed`() {
        val board = boardOf(6).seed(0 to 1, 3 to 4)
        fun refused(write: () -> Unit) {
            assertThrows(AssertionError::class.java, write)
        }
        refused { board.take(2, 0, board.attemptNumber(0, 0), 0) }
        refused { board.take(3, 0, board.attemptNumber(0, 0), 0) }
        refused { board.own(1, 0) }
        refused { board.hang(0, 1) }
        refused { board.giveBack(0, 0.0) }
        board.take(0, 0, board.attemptNumber(2, 0), 0)
        refused { board.release(0, 1) }
        board.release(0, 2)
    }

    private companion object {
        const val TURNS = 60_000
    }
}
