package daphnis.actors.region

import daphnis.actors.gas
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.engine.islands.IslandField
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

class RegionMapTest {
    private fun fieldOf(p: Population, boundary: BoundaryConditions, duration: Double): IslandField {
        val step = CollisionStep(p, boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters())
        step.duration = duration
        return IslandField(1).apply {
            measure(step)
            prepare()
        }
    }

    private val layouts = listOf(
        RegionLayout.Stretches(1),
        RegionLayout.Stretches(7),
        RegionLayout.Stretches(500),
        RegionLayout.Blocks(1, 1, 1),
        RegionLayout.Blocks(2, 3, 2),
        RegionLayout.Blocks(1, 9, 1),
    )

    private fun RegionMap.slotsOf(region: Int): List<Int> = buildList {
        forEachStretch(region) { from, to -> for (slot in from until to) add(slot) }
    }

    @Test
    fun `every slot belongs to one region, and is in one of its stretches`() {
        val (p, boundary) = gas(400, 1)
        val field = fieldOf(p, boundary, 0.1)
        for (layout in layouts) {
            val map = RegionMap(layout).apply { prepare(field.rows, field.grid, boundary) }
            val slots = (0 until map.count).flatMap { region ->
                map.slotsOf(region).onEach { assertEquals(region, map.regionOf(it)) { "$layout, slot $it" } }
            }
            assertEquals((0 until p.size).toList(), slots.sorted()) { "$layout" }
        }
    }

    @Test
    fun `stretches hold equally many spheres, one after the other`() {
        val (p, boundary) = gas(400, 2)
        val field = fieldOf(p, boundary, 0.1)
        for (count in listOf(1, 3, 7, 400, 500)) {
            val map = RegionMap(RegionLayout.Stretches(count)).apply { prepare(field.rows, field.grid, boundary) }
            val sizes = List(count) { map.slotsOf(it).size }
            assertTrue(sizes.max() - sizes.min() <= 1) { "$count stretches hold $sizes" }
            for (slot in 1 until p.size) assertTrue(map.regionOf(slot) >= map.regionOf(slot - 1))
        }
    }

    @Test
    fun `blocks are equal boxes that fill the space of the spheres`() {
        val (p, boundary) = gas(400, 4)
        val field = fieldOf(p, boundary, 0.1)
        val map = RegionMap(RegionLayout.Blocks(2, 3, 4)).apply { prepare(field.rows, field.grid, boundary) }
        val number = intArrayOf(2, 3, 4)
        val least = DoubleArray(3) { axis -> (0 until p.size).minOf { field.rows.state[it * STRIDE + axis] } }
        val most = DoubleArray(3) { axis -> (0 until p.size).maxOf { field.rows.state[it * STRIDE + axis] } }
        for (slot in 0 until p.size) {
            val block = map.regionOf(slot).let { intArrayOf(it / 12, it / 4 % 3, it % 4) }
            for (axis in 0..2) {
                val width = (most[axis] - least[axis]) / number[axis]
                val from = field.rows.state[slot * STRIDE + axis] - least[axis] - block[axis] * width
                assertTrue(from in -1e-9..width + 1e-9) { "slot $slot along axis $axis" }
            }
        }
        assertEquals((0 until 24).toSet(), (0 until p.size).map { map.regionOf(it) }.toSet())
    }

    @Test
    fun `spheres that may see one another are in regions that are neighbours, and far regions are not`() {
        var strangers = 0
        for (seed in 1L..6L) {
            val (p, boundary) = gas(400, seed)
            val field = fieldOf(p, boundary, 0.02)
            for (layout in layouts) {
                val map = RegionMap(layout).apply { prepare(field.rows, field.grid, boundary) }
                for (a in 0 until p.size) {
                    for (b in 0..a) {
                        if (!maySee(field, boundary, a, b)) continue
                        assertTrue(map.areNeighbours(map.regionOf(a), map.regionOf(b))) {
                            "seed $seed, $layout: $a, $b"
                        }
                    }
                }
                for (a in 0 until map.count) {
                    for (b in 0 until map.count) {
                        assertEquals(map.areNeighbours(a, b), map.areNeighbours(b, a))
                        if (!map.areNeighbours(a, b)) strangers++
                    }
                }
            }
        }
        assertTrue(strangers > 1000) { "only $strangers pairs of regions are no neighbours" }
    }

    private fun maySee(field: IslandField, boundary: BoundaryConditions, a: Int, b: Int): Boolean = (0..2).all { axis ->
        val gap = abs(field.rows.state[a * STRIDE + axis] - field.rows.state[b * STRIDE + axis])
        val isPeriodic = boundary.contactFaces(axis) == ContactFaces.PERIODIC
        val nearest = if (isPeriodic) minOf(gap, boundary.box.length(axis) - gap) else gap
        axis == boundary.shear?.slideAxis || nearest <= field.grid.sight(axis)
    }

    @Test
    fun `the number of regions suits spheres and threads, and has bounds`() {
        assertEquals(4, RegionLayout.of(100_000, 4).count)
        assertEquals(3, RegionLayout.of(7_999, 4).count)
        assertEquals(1, RegionLayout.of(10, 64).count)
        assertEquals(RegionLayout.MOST, RegionLayout.of(Int.MAX_VALUE, 1_000_000).count)
        assertEquals(12, RegionLayout.Blocks(2, 3, 2).count)
        assertThrows(IllegalArgumentException::class.java) { RegionLayout.Stretches(0) }
        assertThrows(IllegalArgumentException::class.java) { RegionLayout.Stretches(4097) }
        assertThrows(IllegalArgumentException::class.java) { RegionLayout.Blocks(-1, -1, 1) }
        assertThrows(IllegalArgumentException::class.java) { RegionLayout.Blocks(4096, 4096, 4096) }
    }
}
