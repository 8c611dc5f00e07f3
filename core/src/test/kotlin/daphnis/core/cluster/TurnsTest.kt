package daphnis.core.cluster

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.util.Random
import java.util.concurrent.Callable
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicInteger

@Timeout(60)
class TurnsTest {
    private val sent = AtomicInteger()

    /** What each of [nodes] nodes returns from [work]; nothing may be left in the mail. */
    private fun <T> together(nodes: Int, seed: Long = 0, work: (Turns) -> T): List<T> {
        val random = Random(seed)
        val room = MailRoom(nodes) { _, _, _ ->
            sent.incrementAndGet()
            // In any order of nodes.
            if (synchronized(random) { random.nextInt(8) } == 0) Thread.sleep(1)
        }
        val pool = Executors.newFixedThreadPool(nodes)
        try {
            val all = (0 until nodes).map { node -> pool.submit(Callable { work(Turns(room.mail(node))) }) }
            return all.map { it.get() }.also { assertEquals(0, room.unread()) }
        } finally {
            pool.shutdownNow()
        }
    }

    private fun rounds(nodes: Int) = 32 - Integer.numberOfLeadingZeros(nodes - 1)

    @ParameterizedTest
    @ValueSource(ints = [1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 16, 17, 33])
    fun `all hear what each has said, in few messages`(nodes: Int) {
        val heard = together(nodes) { turns ->
            List(3) { turn -> turns.gather(doubleArrayOf(turns.rank + 0.5, turn.toDouble())).map { it.toList() } }
        }
        val expected = List(3) { turn -> List(nodes) { listOf(it + 0.5, turn.toDouble()) } }
        for (one in heard) assertEquals(expected, one)
        assertEquals(3 * nodes * rounds(nodes), sent.get())
    }

    @ParameterizedTest
    @ValueSource(ints = [1, 2, 3, 4, 5, 8, 13])
    fun `what is for one node comes to that alone, turn after turn`(nodes: Int) {
        for (seed in 1L..20L) {
            sent.set(0)
            val turns = 5
            val random = Random(seed)
            val says = Array(turns) { Array(nodes) { BooleanArray(nodes) { random.nextInt(3) == 0 } } }
            val all = together(nodes, seed) { mine -> List(turns) { turn -> mine.one(turn, says[turn]) } }
            for (node in 0 until nodes) {
                for (turn in 0 until turns) {
                    val others = (0 until nodes).filter { it != node }
                    val ones = others.filter { says[turn][it][node] }.map { "$turn: $it to $node" }
                    assertEquals(ones + others.map { "$turn: $it to all" }, all[node][turn])
                }
            }
            val next = (0 until nodes).sumOf { from ->
                (0 until turns).sumOf { turn ->
                    (0 until nodes).count { says[turn][from][it] && it != from && it != (from + 1) % nodes }
                }
            }
            assertEquals(turns * nodes * rounds(nodes) + next, sent.get())
        }
    }

    private fun Turns.one(turn: Int, says: Array<BooleanArray>): List<String> {
        val heard = ArrayList<String>()
        exchange(
            { to, message -> if (says[rank][to]) message.text("$turn: $rank to $to") },
            { text("$turn: $rank to all") },
            { _, message -> heard += message.text() },
            { _, message -> heard += message.text() },
        )
        return heard
    }

    @ParameterizedTest
    @ValueSource(ints = [2, 3, 5, 8])
    fun `a failure is thrown at all others, who then go on together`(nodes: Int) {
        val ends = together(nodes) { turns ->
            val first = try {
                turns.exchange(
                    { to, message ->
                        if (turns.rank == 1 && to == 0) error("broken")
                        message.text("hello")
                    },
                    { if (turns.rank == 1) error("broken") },
                    { _, _ -> },
                    { _, _ -> },
                )
                "fine"
            } catch (e: NodeFailedException) {
                "${e.rank}: ${e.message}"
            } catch (e: IllegalStateException) {
                turns.fail(e)
                "failed"
            }
            first to turns.gather(doubleArrayOf(turns.rank.toDouble())).map { it[0] }
        }
        for ((node, end) in ends.withIndex()) {
            val expected = if (node == 1) "failed" else "1: java.lang.IllegalStateException: broken"
            assertEquals(expected, end.first)
            assertEquals(List(nodes) { it.toDouble() }, end.second)
        }
    }

    @ParameterizedTest
    @ValueSource(ints = [3, 6, 9])
    fun `what fails while messages go around is no failure that others could be told of`(nodes: Int) {
        for (bad in 2..rounds(nodes)) {
            var count = 0
            lateinit var room: MailRoom
            room = MailRoom(nodes) { from, _, _ -> if (from == 1 && ++count == bad) throw OutOfMemoryError("made up") }
            val pool = Executors.newFixedThreadPool(nodes)
            val ends = (0 until nodes).map { node ->
                pool.submit(
                    Callable {
                        try {
                            Turns(room.mail(node)).gather(doubleArrayOf(1.0))
                            // Others may have heard all.
                            null
                        } catch (e: TornTurnException) {
                            // As a node's work does which ends.
                            room.end("torn")
                            e.cause
                        } catch (e: MailClosedException) {
                            e
                        }
                    },
                )
            }.map { it.get() }
            pool.shutdownNow()
            assertTrue(ends[1] is OutOfMemoryError) { "${ends[1]}" }
            assertTrue(ends.any { it is MailClosedException }) { "$ends" }
        }
    }

    @Test
    fun `of several failures the first by rank is told`() {
        val ends = together(5) { turns ->
            if (turns.rank in setOf(2, 4)) {
                turns.fail(IllegalStateException("${turns.rank}"))
                -1
            } else {
                try {
                    turns.tell({ int(1) }) { _, _ -> }
                    -2
                } catch (e: NodeFailedException) {
                    e.rank
                }
            }
        }
        assertEquals(listOf(2, 2, -1, 2, -1), ends)
    }

    @Test
    fun `the greatest of all, and the bytes that were sent`() {
        val all = together(6) { turns ->
            val numbers = doubleArrayOf(turns.rank.toDouble(), -turns.rank.toDouble())
            turns.max(numbers)
            numbers to turns.bytesSent
        }
        for ((numbers, bytes) in all) {
            assertArrayEquals(doubleArrayOf(5.0, -0.0), numbers)
            assertTrue(bytes in 6 * 16L..6 * 64L) { "$bytes" }
        }
    }
}
