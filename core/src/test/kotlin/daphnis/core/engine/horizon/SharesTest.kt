package daphnis.core.engine.horizon

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.Pieces
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SharesTest {
    @Test
    fun `a sphere without a cell belongs to the group in whose rows it is, whoever looks for it`() {
        val space = space()
        val cells = space.cells
        for (loop in listOf(InlineLoop, Pieces)) {
            val shares = Shares()
            shares.divide(GROUPS, cells, N, loop)
            for (group in 0 until GROUPS) assertTrue(shares.endOf(group) - shares.firstOf(group) in N / 5..N / 2)
            val owners = (cells.members until N).map { slot ->
                val first = cells.start[cells.rowAtMiddle(slot) * cells.count[0]]
                val owner = (0 until GROUPS).first { first < shares.endOf(it) }
                assertEquals(owner, shares.ownerOf(slot)) { "slot $slot" }
                owner
            }
            assertEquals((0 until GROUPS).toSet(), owners.toSet())
        }
    }

    /** A gas, some of whose spheres are too fast for cells, laid out. */
    private fun space(): EpochSpace {
        val random = SeededRandom(5)
        fun places() = DoubleArray(N) { random.nextDouble(-HALF, HALF) }
        fun speeds() = DoubleArray(N) { (if (it % 20 == 0) 9.0 else 0.5) * random.nextGaussian() }
        val ones = DoubleArray(N) { 1.0 }
        val p = Population(places(), places(), places(), speeds(), speeds(), speeds(), ones, ones.copyOf())
        val box = Periodic(Box.centred(2 * HALF, 2 * HALF, 2 * HALF))
        val space = EpochSpace(InlineLoop)
        space.measure(p, box, 0.1)
        space.frame.memberRadius = 1.0
        val tuning = HorizonTuning(2)
        assertTrue(space.frame.begin(tuning))
        space.cells.sort(p, tuning, 0.0)
        Passage(space, InlineLoop).first(p, space.cells, p.columnsToWrite(tracksLastCollision = false))
        assertTrue(space.cells.members in N * 4 / 5..N - 20) { "${space.cells.members} members" }
        return space
    }

    private companion object {
        const val N = 3000
        const val GROUPS = 3
        const val HALF = 40.0
    }
}
