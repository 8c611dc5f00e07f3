package daphnis.core.cluster

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.time.Duration
import java.util.function.Consumer

@Timeout(60)
class NodesAwaitedTest {
    private val lines = ArrayList<String>()

    /** What the fleet says, one after the other; the last for ever. */
    private class Said(private vararg val sights: Sight) : Fleet {
        private var at = 0

        override fun nodes(): List<FleetNode> = List(sights[at].free) { FleetNode("n$it", 1, 1) }

        override fun busy(): List<BusyNode> =
            sights[at].runs.map { BusyNode("b", it) }.also { at = minOf(at + 1, sights.lastIndex) }

        override fun form(nodes: List<FleetNode>) = throw UnsupportedOperationException()

        override fun close() = Unit
    }

    private class Sight(val free: Int, vararg val runs: String)

    private fun await(count: Int, patience: Duration, vararg sights: Sight): List<FleetNode> =
        NodesAwaited(Said(*sights), patience, Consumer(lines::add)).await(count)

    @Test
    fun `nodes that are there are had without a word`() {
        assertEquals(3, await(2, Duration.ZERO, Sight(3)).size)
        assertEquals(emptyList<String>(), lines)
    }

    @Test
    fun `busy nodes are waited for beyond all patience, and each change is told once`() {
        val ring = "ring of a:1"
        val sights = arrayOf(Sight(0, ring, ring), Sight(0, ring, ring), Sight(1, "gas of b:2"), Sight(2))
        assertEquals(2, await(2, Duration.ZERO, *sights).size)
        val expected = listOf(
            "0 of 2 nodes are there, 2 nodes are busy with the run ring of a:1; waiting for them",
            "1 of 2 nodes is there, 1 node is busy with the run gas of b:2; waiting for it",
        )
        assertEquals(expected, lines)
        lines.clear()
        await(1, Duration.ZERO, Sight(0, ring, "gas of b:2"), Sight(1))
        val said = "2 nodes are busy with the run ring of a:1 and of gas of b:2; waiting for them"
        assertEquals(listOf(said), lines)
    }

    @Test
    fun `too few nodes are waited for as long as patience lasts`() {
        val none = assertThrows(FleetException::class.java) { await(1, Duration.ZERO, Sight(0)) }
        assertEquals("no node has come within 0 s", none.message)
        val few = assertThrows(FleetException::class.java) { await(3, Duration.ofMillis(1), Sight(1, "x of y:1")) }
        assertEquals("1 of 3 nodes has come within 0 s", few.message)
        val said = "1 of 3 nodes is there, 1 node is busy with the run x of y:1; waiting for 0 s"
        assertEquals(listOf("no node is there; waiting for 0 s", said), lines.takeLast(2))
        assertThrows(IllegalArgumentException::class.java) { await(0, Duration.ZERO, Sight(0)) }
    }
}
