package daphnis.core.population

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SphereQuantityTest {
    @Test
    fun `columns that have a name are at the place of their quantity`() {
        val given = List(8) { DoubleArray(2) { k -> 1.0 + it + k } }
        val p = Population(given[0], given[1], given[2], given[3], given[4], given[5], given[6], given[7])
            .withSpin(given[5], given[6], given[7])
        val named = listOf(p.x, p.y, p.z, p.vx, p.vy, p.vz, p.radius, p.mass, p.wx, p.wy, p.wz, p.lastCollision)
        val quantities = listOf("POSITION", "VELOCITY", "RADIUS", "MASS", "SPIN", "LAST_COLLISION").map {
            SphereQuantity.valueOf(it)
        }
        val places = quantities.flatMap { it.places }
        assertEquals(named.size, places.size)
        for ((k, place) in places.withIndex()) assertSame(named[k], p.column(place)) { "$k" }
        for (axis in 0..2) {
            assertSame(named[axis], p.position(axis))
            assertSame(named[3 + axis], p.velocity(axis))
        }
    }

    @Test
    fun `names are told once, and what files have stands before what they do not`() {
        for (names in listOf<(SphereQuantity) -> List<String>>({ it.columns }, { it.records }, { listOf(it.title) })) {
            val all = SphereQuantity.entries.flatMap(names)
            assertEquals(all.size, all.toSet().size) { "$all" }
        }
        assertTrue(SphereQuantity.entries.all { it.records.size == it.columns.size })
        assertTrue(SphereQuantity.entries.flatMap { it.records }.all { it.length == 4 })
        assertEquals(SphereQuantity.entries.filter { it.isExported }, SphereQuantity.EXPORTED)
    }

    @Test
    fun `dimensions are written as H5MD and tables write them, and convert numbers`() {
        val velocity = SphereQuantity.VELOCITY.dimension
        assertEquals("m s-1", velocity.symbols("m", "s", "kg"))
        assertEquals("length/time", velocity.words())
        assertEquals(0.1 / 0.3, velocity.of(0.1, 0.3, 7.0))
        assertEquals("1/time", SphereQuantity.Powers(time = -1).words())
        assertEquals("mass length^2/time^2", SphereQuantity.Powers(length = 2, time = -2, mass = 1).words())
        assertEquals(7.0, SphereQuantity.MASS.dimension.of(2.0, 3.0, 7.0))
    }
}
