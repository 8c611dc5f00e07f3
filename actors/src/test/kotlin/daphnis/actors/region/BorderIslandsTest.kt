package daphnis.actors.region

import daphnis.actors.gas
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.islands.IslandField
import daphnis.core.engine.islands.IslandWorkers
import daphnis.core.initial.SeededRandom
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class BorderIslandsTest {
    private val count = 12

    /** The first window of a step on twelve stretches of a long gas, with all its islands across borders. */
    private inner class Window(seed: Long) {
        val map = RegionMap(RegionLayout.Stretches(count))
        val field = IslandField(count)
        val workers = IslandWorkers(field, count)
        val border = BorderIslands(map, workers)
        val roots: List<Int>

        init {
            val (p, boundary) = gas(1500, seed)
            val step = CollisionStep(p, boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters())
            step.duration = 0.1
            field.measure(step)
            field.prepare()
            workers.prepare()
            map.prepare(field.rows, field.grid, boundary)
            val regions = List(count) { Region(it, map, workers) }
            fun all(phase: Phase) = regions.forEach { it.handle(RegionCommand(it.number, phase)) }
            all(Phase.SEARCH)
            // Windows with too few of them are left unprocessed.
            while (true) {
                if (workers.openWindow() == 0) continue
                all(Phase.PROPOSE)
                workers.joinBorders()
                if (workers.rootCount >= 4) break
                workers.mergeConflicts()
                workers.closeWindow()
            }
            roots = List(workers.rootCount) { workers.root(it) }
        }

        /** The regions of the spheres of [root] and [also], and their neighbours. */
        fun needs(root: Int, also: Int = -1): BooleanArray {
            val needed = BooleanArray(count)
            fun around(slot: Int) {
                for (k in 0 until count) if (map.areNeighbours(map.regionOf(slot), k)) needed[k] = true
            }
            workers.forEachSeeded(root, ::around)
            if (also >= 0) around(also)
            return needed
        }

        fun granted(): List<RegionCommand> = buildList { border.grant(::add) }

        fun giveBack(command: RegionCommand, vararg border: Int) {
            this.border.returned(RegionReply(command.region, Phase.GRANT, border))
        }
    }

    @Test
    fun `every island is granted once, under the locks it needs, and no two grants share a region`() {
        var together = 0
        for (seed in 1L..12L) {
            val window = Window(seed)
            val random = SeededRandom(seed)
            for (root in window.roots) window.border.add(root, -1, null)
            val islands = ArrayList<Int>()
            val out = ArrayList<RegionCommand>()
            while (!window.border.isEmpty) {
                out += window.granted()
                together = maxOf(together, out.size)
                val locked = IntArray(count)
                for (command in out) for (k in 0 until count) if (command.locked[k]) locked[k]++
                assertTrue(locked.all { it <= 1 }) { "seed $seed: two grants share a region" }
                assertTrue(window.granted().isEmpty()) { "seed $seed: granted late" }
                val done = out.removeAt(random.nextInt(out.size))
                assertEquals(Phase.GRANT, done.phase)
                assertEquals(done.locked.indexOf(true), done.region)
                for (root in done.islands) assertArrayEquals(window.needs(root), done.locked)
                islands += done.islands.toList()
                window.giveBack(done)
            }
            assertTrue(out.isEmpty())
            assertEquals(window.roots.sorted(), islands.sorted()) { "seed $seed" }
        }
        assertTrue(together > 1) { "never two grants at a time" }
    }

    @Test
    fun `the batch with the first collision goes first`() {
        val window = Window(3)
        for (root in window.roots) window.border.add(root, -1, null)
        val first = window.roots.minBy { window.workers.startOf(it) }
        assertTrue(first in window.granted().first().islands.toList())
    }

    @Test
    fun `islands that need the same regions are one batch`() {
        val window = Window(4)
        for (root in window.roots) window.border.add(root, -1, null)
        val kinds = window.roots.map { window.needs(it).toList() }.toSet().size
        var batches = 0
        while (!window.border.isEmpty) {
            val out = window.granted()
            batches += out.size
            out.forEach { window.giveBack(it) }
        }
        assertEquals(kinds, batches)
        assertTrue(kinds < window.roots.size) { "no two islands need the same regions" }
    }

    @Test
    fun `an island that is given back comes again with the regions of the sphere it lacked, and those it had`() {
        val window = Window(5)
        val root = window.roots[0]
        window.border.add(root, -1, null)
        val first = window.granted().single()
        val stranger = (0 until window.field.size).first { !first.locked[window.map.regionOf(it)] }
        window.giveBack(first, root, stranger)
        assertFalse(window.border.isEmpty)
        val second = window.granted().single()
        assertEquals(listOf(root), second.islands.toList())
        assertArrayEquals(window.needs(root, stranger), second.locked)
        val third = (0 until window.field.size).firstOrNull { !second.locked[window.map.regionOf(it)] }
        window.giveBack(second, root, third ?: stranger)
        val last = window.granted().single().locked
        assertTrue((0 until count).all { last[it] || !second.locked[it] }) { "a region it had is missing" }
    }

    @Test
    fun `after a step that failed nothing waits and nothing is locked`() {
        val window = Window(6)
        for (root in window.roots) window.border.add(root, -1, null)
        val before = window.granted().map { it.region }
        window.border.clear()
        assertTrue(window.border.isEmpty && window.granted().isEmpty())
        for (root in window.roots) window.border.add(root, -1, null)
        assertEquals(before, window.granted().map { it.region })
        window.giveBack(RegionCommand(count - 1, Phase.GRANT))
    }
}
