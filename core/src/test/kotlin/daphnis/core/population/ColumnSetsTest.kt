package daphnis.core.population

import daphnis.core.Sphere
import daphnis.core.initial.SeededRandom
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The sets of columns of a population take turns, however often a step writes, and none is from before the step. */
class ColumnSetsTest {
    private fun population(): Population = populationOf(*Array(3) { Sphere(x = 4.0 * it, r = 1.0 + it) })

    private fun state(p: Population): List<List<Any>> = (0 until p.size).map { k ->
        val sphere = listOf(p.id[k], p.x[k], p.vx[k], p.radius[k], p.mass[k], p.lastCollision[k])
        sphere + p.boxesCrossed(p.id[k], 0)
    }

    /** Writes all spheres, each one place further when [keepsOrder] is not set. */
    private fun write(p: Population, keepsOrder: Boolean, tracks: Boolean = false): PopulationColumns {
        val columns = p.columnsToWrite(tracks, keepsOrder = keepsOrder)
        for (k in 0 until p.size) {
            val from = if (keepsOrder) k else (k + 1) % p.size
            columns.x[k] = p.x[from] + 100
            columns.vx[k] = p.vx[from] - 1
            if (tracks) columns.lastCollision[k] = minOf(0.0, p.lastCollision[from]) - 1
            if (keepsOrder) continue
            columns.radius[k] = p.radius[from]
            columns.mass[k] = p.mass[from]
            columns.id[k] = p.id[from]
        }
        return columns
    }

    @Test
    fun `a step that was written several times, with and without another order, is taken back`() {
        val p = population()
        val before = state(p)
        p.beginStep()
        for (keepsOrder in listOf(true, false, true, false)) p.take(write(p, keepsOrder))
        p.takeStepBack()
        assertEquals(before, state(p))
    }

    @Test
    fun `whatever a step writes, gives back, removes and adds, it is taken back`() {
        var takenBack = 0
        for (seed in 1L..3000L) {
            val random = SeededRandom(seed)
            val p = population()
            for (step in 1..12) {
                val before = state(p)
                p.beginStep()
                repeat(1 + random.nextInt(5)) {
                    if (random.nextInt(6) == 0) p.giveBack(write(p, keepsOrder = true))
                    val columns = write(p, random.nextInt(2) == 0, tracks = random.nextInt(8) == 0)
                    if (random.nextInt(10) != 0) p.take(columns)
                    p.addCrossing(random.nextInt(p.size), 0, 1)
                }
                if (random.nextInt(10) == 0) {
                    val gone = p.id[0]
                    p.retain { p.id[it] != gone }
                    val one = doubleArrayOf(5.0)
                    p.add(Population(one, one, one, one, one, one, one, one, intArrayOf(1000 * step)))
                }
                if (random.nextInt(3) == 0) {
                    p.takeStepBack()
                    assertEquals(before, state(p)) { "seed $seed, step $step" }
                    takenBack++
                } else {
                    p.commitStep()
                }
            }
        }
        assertTrue(takenBack > 3000) { "$takenBack" }
    }

    @Test
    fun `after a step that wrote nothing the next one is not written in place`() {
        val p = population()
        p.take(write(p, keepsOrder = true))
        val before = state(p)
        p.beginStep()
        p.commitStep()
        p.beginStep()
        p.take(write(p, keepsOrder = true))
        p.takeStepBack()
        assertEquals(before, state(p))
    }

    @Test
    fun `a crossing between two steps is not taken back with the second`() {
        val p = population()
        p.beginStep()
        p.commitStep()
        p.addCrossing(1, 0, 2)
        p.takeStepBack()
        assertEquals(2, p.boxesCrossed(p.id[1], 0))
        p.beginStep()
        p.addCrossing(1, 0, 3)
        p.takeStepBack()
        assertEquals(2, p.boxesCrossed(p.id[1], 0))
    }
}
