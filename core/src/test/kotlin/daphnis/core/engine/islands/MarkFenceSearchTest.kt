package daphnis.core.engine.islands

import daphnis.core.Sphere
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

/**
 * Of two islands that mark their spheres, announce them and then search, at least one sees the mark of the other: the
 * board itself on two threads at once, many times, and every course that its steps can take in a model of memory.
 */
@Timeout(120)
class MarkFenceSearchTest {
    @Test
    fun `on two threads at once at least one sees the other's mark`() {
        val n = 2 * PAIRS
        val rows = StepRows().apply {
            load(populationOf(*Array(n) { Sphere(x = 3.0 * it) }), IntArray(n) { it }, 1.0, false)
        }
        val board = IslandBoard(rows, 2)
        repeat(ROUNDS) { round ->
            board.prepare(n)
            for (slot in 0 until n) {
                rows.state[slot * STRIDE + TIME] = 0.0
                board.claim(slot, slot % 2)
            }
            val seen = Array(2) { BooleanArray(PAIRS) }
            inStep(PAIRS) { worker, pair ->
                board.take(2 * pair + worker, worker, board.attemptNumber(worker, 0), pair)
                board.announce()
                seen[worker][pair] = rows.state[(2 * pair + 1 - worker) * STRIDE + TIME].isNaN()
            }
            val missed = (0 until PAIRS).filter { !seen[0][it] && !seen[1][it] }
            assertEquals(emptyList<Int>(), missed) { "round $round: pairs of which neither saw the other" }
        }
    }

    /** A step of one of the two islands; variables 0 and 1 are its own mark and bound, 2 and 3 the other's. */
    private enum class Op { WRITE_BOUND, WRITE_MARK, FENCE, READ_BOUND, READ_MARK }

    private val course = listOf(Op.WRITE_MARK, Op.WRITE_BOUND, Op.FENCE, Op.READ_BOUND, Op.READ_MARK)

    @Test
    fun `in every course of the steps at least one island sees bound and mark of the other`() {
        val ends = ends(course)
        assertTrue(ends.none { (a, b) -> !a && !b }) { "both missed the other" }
        assertTrue((true to false) in ends && (false to true) in ends && (true to true) in ends)
    }

    @Test
    fun `without the fence, or with the search before the mark, both can miss`() {
        assertTrue((false to false) in ends(course - Op.FENCE))
        assertTrue(
            (false to false) in ends(listOf(Op.WRITE_BOUND, Op.FENCE, Op.READ_BOUND, Op.READ_MARK, Op.WRITE_MARK)),
        )
        assertTrue(
            (false to false) in ends(listOf(Op.WRITE_MARK, Op.FENCE, Op.WRITE_BOUND, Op.READ_BOUND, Op.READ_MARK)),
        )
    }

    /**
     * Which of the two islands sees both writes of the other, in all courses that memory allows: writes of an island
     * wait in its buffer and reach memory one by one, in any order, at any time; a fence waits for all of its own.
     */
    private fun ends(course: List<Op>): Set<Pair<Boolean, Boolean>> = buildSet {
        val visited = HashSet<State>()
        fun visit(state: State) {
            if (!visited.add(state)) return
            val next = state.next(course)
            if (next.isEmpty()) add(state.hasSeenAll(0) to state.hasSeenAll(1))
            next.forEach(::visit)
        }
        visit(State(listOf(0, 0), emptySet(), emptySet(), emptySet()))
    }

    /**
     * @property at the next step of each island
     * @property waiting written variables that are still in the buffer of their island: island and step
     * @property written those that are in memory
     * @property seen reads that found what the other had written
     */
    private data class State(
        val at: List<Int>,
        val waiting: Set<Pair<Int, Op>>,
        val written: Set<Pair<Int, Op>>,
        val seen: Set<Pair<Int, Op>>,
    ) {
        fun hasSeenAll(island: Int) = (island to Op.READ_BOUND) in seen && (island to Op.READ_MARK) in seen

        fun next(course: List<Op>): List<State> = waiting.map { copy(waiting = waiting - it, written = written + it) } +
            (0..1).filter { at[it] < course.size }.mapNotNull { step(it, course[at[it]]) }

        private fun step(island: Int, op: Op): State? {
            val moved = copy(at = at.mapIndexed { k, place -> if (k == island) place + 1 else place })
            return when (op) {
                Op.WRITE_BOUND, Op.WRITE_MARK -> moved.copy(waiting = waiting + (island to op))
                Op.FENCE -> if (waiting.any { it.first == island }) null else moved
                Op.READ_BOUND -> moved.see(island, op, Op.WRITE_BOUND)
                Op.READ_MARK -> moved.see(island, op, Op.WRITE_MARK)
            }
        }

        private fun see(island: Int, read: Op, write: Op) =
            if ((1 - island to write) in written) copy(seen = seen + (island to read)) else this
    }

    private companion object {
        const val PAIRS = 20_000
        const val ROUNDS = 5
    }
}
