package daphnis.cluster.downing

import daphnis.cluster.downing.Parting.Decision.OTHERS_GO
import daphnis.cluster.downing.Parting.Decision.SELF_GOES
import daphnis.cluster.downing.Parting.Seen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class PartingTest {
    private fun nodes(reachable: Int, lost: Int) =
        List(reachable) { Seen(false, it, true) } + List(lost) { Seen(false, reachable + it, false) }

    private fun run(isReachable: Boolean, age: Int = 50) = Seen(true, age, isReachable)

    @Test
    fun `the part with the run goes on, however small it is`() {
        assertEquals(OTHERS_GO, Parting.decide(nodes(0, 3) + run(true)))
        assertEquals(OTHERS_GO, Parting.decide(nodes(1, 9) + run(true)))
    }

    @Test
    fun `without the run the greater part of the nodes stays, and parts of one size both do`() {
        assertEquals(OTHERS_GO, Parting.decide(nodes(2, 1) + run(false)))
        assertEquals(SELF_GOES, Parting.decide(nodes(1, 2) + run(false)))
        assertEquals(OTHERS_GO, Parting.decide(nodes(1, 1) + run(false)))
        assertEquals(OTHERS_GO, Parting.decide(nodes(1, 1)))
        assertEquals(SELF_GOES, Parting.decide(nodes(2, 3)))
        assertEquals(OTHERS_GO, Parting.decide(nodes(1, 0) + run(false)))
    }

    @Test
    fun `of two runs the older one counts`() {
        assertEquals(SELF_GOES, Parting.decide(nodes(1, 2) + run(true, 60) + run(false)))
        assertEquals(OTHERS_GO, Parting.decide(nodes(1, 2) + run(true) + run(false, 60)))
    }
}
