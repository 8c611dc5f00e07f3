package daphnis.core.cluster

import daphnis.core.cluster.bricks.AttemptKey
import daphnis.core.cluster.bricks.Mailboxes
import daphnis.core.cluster.bricks.Outcome
import daphnis.core.cluster.bricks.PathList
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.Callable
import java.util.concurrent.Executors

@Timeout(60)
class RemoteBricksTest {
    private val threads = intArrayOf(1, 2)
    private val room = MailRoom(threads.size)

    /** What brick 0 says to the bricks 1 and 2: the number of paths by receiver. */
    private fun outcomes(paths: Map<Int, Int>) = paths.mapValues { (_, count) ->
        val list = PathList()
        for (k in 0 until count) list.add(k, 70L + k)
        Outcome(AttemptKey(1, 0, 0), 0, list, DoubleArray(3) { 0.5 })
    }

    /** What the bricks of [places] get in one turn, in words. */
    private fun turn(places: RemoteBricks, said: Map<Int, Outcome>): List<String> {
        val boxes = Mailboxes(threads.sum())
        for ((to, outcome) in said) boxes.post(0).send(to, outcome)
        boxes.turn()
        places.carry(boxes)
        val got = ArrayList<String>()
        for (brick in places.from(threads.sum()) until places.to(threads.sum())) {
            boxes.take(brick) { got += "$brick from ${it.from}: ${(it as Outcome).paths.size} paths" }
        }
        return got
    }

    @Test
    fun `a brick gets what was said to it alone, or else that nothing was, and one of the two only, once`() {
        val pool = Executors.newFixedThreadPool(threads.size)
        val nodes = threads.indices.map { RemoteBricks(Turns(room.mail(it)), threads) }
        fun all(says: List<Map<Int, Outcome>>) =
            pool.invokeAll(says.indices.map { Callable { turn(nodes[it], says[it]) } }).map { it.get() }
        try {
            val got = all(listOf(outcomes(mapOf(1 to 4, 2 to 0)), emptyMap()))
            assertEquals(listOf(emptyList(), listOf("1 from 0: 4 paths", "2 from 0: 0 paths")), got)
            assertEquals(listOf(emptyList<String>(), emptyList()), all(listOf(emptyMap(), emptyMap())))
        } finally {
            pool.shutdownNow()
        }
    }
}
