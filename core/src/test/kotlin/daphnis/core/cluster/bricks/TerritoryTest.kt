package daphnis.core.cluster.bricks

import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** [Cuts], [Territory] and [Vicinity]: who owns what, and who needs a copy. */
class TerritoryTest {
    private val box = Box(0.0, -5.0, 0.0, 12.0, 5.0, 8.0)
    private val none = DoubleArray(0)

    private fun territory(boundary: BoundaryConditions, vararg planes: DoubleArray) =
        Territory(Cuts(planes.asList(), boundary), boundary, epoch = 1)

    @Test
    fun `planes along an open axis leave the outer parts without an end`() {
        val t = territory(Open, doubleArrayOf(-1.0, 2.0), none, none)
        assertEquals(3, t.size)
        val places = listOf(-1e9, -1.0001, -1.0, 1.9, 2.0, 1e9)
        assertEquals(listOf(0, 0, 1, 1, 2, 2), places.map { t.ownerOf(it, 0.0, 0.0) })
        assertEquals(listOf(3.0, 0.0, 0.0, 5.0), listOf(-4.0, -1.0, 2.0, 7.0).map { t.distance(0, 1, it) })
        assertEquals(listOf(Double.NEGATIVE_INFINITY, -1.0, 2.0), List(3) { t.lower(0, it) })
        assertTrue(t.middle(1).all { it.isNaN() })
    }

    @Test
    fun `along a periodic axis the last part goes on across the face to the first plane`() {
        val t = territory(Periodic(box), doubleArrayOf(2.0, 7.0, 10.0), none, none)
        assertEquals(listOf(2, 2, 0, 0, 1, 2), listOf(0.0, 1.99, 2.0, 6.9, 7.0, 11.9).map { t.ownerOf(it, 0.0, 0.0) })
        assertEquals(14.0, t.upper(0, 2))
        assertEquals(12.0, t.middle(2)[0])
        // The nearest image counts.
        assertEquals(listOf(0.0, 1.0, 2.0, 1.0), listOf(1.0, 3.0, 8.0, 9.0).map { t.distance(0, 2, it) })
        assertEquals(listOf(1.0, 3.0), listOf(1.0, 11.0).map { t.distance(0, 0, it) })
    }

    @Test
    fun `a place has one owner, from whose territory alone it has no distance`() {
        val random = SeededRandom(3)
        for (boundary in listOf(Open, Periodic(box), Periodic(box, true, false, true), LeesEdwards(box, 0.3))) {
            val x = if (boundary is LeesEdwards) none else doubleArrayOf(1.0, 4.0, 9.0)
            val t = territory(boundary, x, doubleArrayOf(-4.0, 0.5), doubleArrayOf(0.0, 3.0, 7.0))
            repeat(2000) {
                val p = DoubleArray(3) { random.nextDouble(box.lower(it), box.upper(it)) }
                val inside = (0 until t.size).filter { b -> (0..2).all { t.distance(it, t.part(it, b), p[it]) == 0.0 } }
                assertEquals(listOf(t.ownerOf(p[0], p[1], p[2])), inside)
            }
            for (b in 0 until t.size) assertEquals(b, t.brick(t.part(0, b), t.part(1, b), t.part(2, b)))
        }
    }

    @Test
    fun `space is not cut along an axis along which images slide`() {
        val boundary = LeesEdwards(box, 0.3)
        assertThrows(IllegalArgumentException::class.java) { territory(boundary, doubleArrayOf(1.0, 5.0), none, none) }
        val spheres = randomSpheres(50, boundary, 1, 1.0) { 0.3 }
        val cuts = CutPlaces(spheres, boundary).choose(BrickDivision(4, 3, 2), Bodies(), DoubleArray(3))
        assertEquals(listOf(1, 3, 2), List(3) { cuts.parts(it) })
    }

    @Test
    fun `planes are between equally many spheres`() {
        val spheres = randomSpheres(400, Periodic(box), 2, 1.0) { 0.2 }
        for (boundary in listOf(Periodic(box), Open)) {
            val cuts = CutPlaces(spheres, boundary).choose(BrickDivision(4, 1, 5), Bodies(), DoubleArray(3))
            val t = Territory(cuts, boundary, 1)
            val counts = IntArray(t.size)
            for (k in 0 until 400) counts[t.part(2, t.ownerOf(spheres.x[k], spheres.y[k], spheres.z[k]))]++
            assertTrue((0..4).all { counts[it] in 78..82 }) { counts.asList().toString() }
        }
    }

    @Test
    fun `spheres all at one place are not cut apart`() {
        val same = populationOf(Sphere(x = 1.0), Sphere(x = 1.0, y = 3.0), Sphere(x = 1.0, y = 6.0))
        val t = Territory(CutPlaces(same, Open).choose(BrickDivision(3, 1, 1), Bodies(), DoubleArray(3)), Open, 1)
        assertEquals(1, (0..2).map { t.ownerOf(1.0, 0.0, 0.0) }.distinct().size)
        assertEquals(
            1,
            Territory(
                CutPlaces(same, Periodic(box)).choose(BrickDivision(1, 1, 1), Bodies(), DoubleArray(3)),
                Open,
                1,
            ).size,
        )
    }

    @Test
    fun `a sphere concerns its owner and the bricks in whose halo it is, wherever one asks from`() {
        val random = SeededRandom(5)
        var halos = 0
        for (boundary in listOf(Open, Periodic(box), LeesEdwards(box, 0.3))) {
            val x = if (boundary is LeesEdwards) none else doubleArrayOf(1.0, 4.0, 9.0)
            val t = territory(boundary, x, doubleArrayOf(-4.0, 0.5), doubleArrayOf(0.0, 3.0, 7.0))
            val edge = DoubleArray(t.size) { random.nextDouble(0.0, 0.4) }
            val extra = DoubleArray(t.size) { random.nextDouble(0.0, 1.0) }
            val widths = HaloWidths(doubleArrayOf(0.1, 0.2, 0.3), DoubleArray(3), edge, extra)
            val spheres = randomSpheres(300, boundary, 7, 1.0) { it.nextDouble(0.1, 0.3) }
            for (home in 0 until t.size) {
                val vicinity = Vicinity(t, home)
                vicinity.prepare(widths)
                for (k in 0 until spheres.size) {
                    vicinity.look(spheres.x[k], spheres.y[k], spheres.z[k], spheres.radius[k])
                    assertEquals(t.ownerOf(spheres.x[k], spheres.y[k], spheres.z[k]), vicinity.owner)
                    val others = List(vicinity.size) { vicinity.others[it] }
                    assertEquals(near(t, widths, spheres, k) - vicinity.owner, others.toSet())
                    assertEquals(others.distinct(), others)
                    halos += others.size
                }
            }
        }
        assertTrue(halos > 1000)
    }

    /** By definition, over images one box away. */
    private fun near(t: Territory, widths: HaloWidths, spheres: Population, k: Int): Set<Int> =
        (0 until t.size).filter { brick ->
            (0..2).all { axis ->
                val reach = widths.width(axis, brick) + spheres.radius[k]
                val images = if (t.length(axis) > 0) listOf(-1, 0, 1) else listOf(0)
                t.parts(axis) == 1 ||
                    images.any { image ->
                        val x = spheres.position(axis)[k] + image * t.length(axis)
                        val low = t.lower(axis, brick)
                        val high = t.upper(axis, brick)
                        low - x <= reach && x - high <= reach
                    }
            }
        }.toSet()
}
