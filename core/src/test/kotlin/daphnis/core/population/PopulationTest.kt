package daphnis.core.population

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.permuted
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertNotSame
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.Collections
import java.util.IdentityHashMap

class PopulationTest {
    private val flow = MeanFlow(normalAxis = 1, flowAxis = 0, rate = 1.0)

    private val p = randomSpheres(500, Periodic(Box.centred(20.0, 20.0, 20.0)), 5, 1.0) { 0.3 }

    @Test
    fun `digest and sums do not depend on the order of the arrays`() {
        val q = p.permuted(9)
        assertNotEquals(p.x[0], q.x[0])
        assertEquals(stateDigest(p), stateDigest(q))
        val a = Conserved.of(p)
        val b = Conserved.of(q)
        assertEquals(
            listOf(a.kineticEnergy, a.momentumX, a.momentumY, a.momentumZ),
            listOf(b.kineticEnergy, b.momentumX, b.momentumY, b.momentumZ),
        )
        assertEquals(granularTemperature(p, flow), granularTemperature(q, flow))
    }

    @Test
    fun `one flipped bit changes the digest`() {
        val q = p.copy()
        q.vz[123] = Math.nextUp(q.vz[123])
        assertNotEquals(stateDigest(p), stateDigest(q))
    }

    @Test
    fun `the digest is SHA-256 over big-endian doubles in id order`() {
        // sha256 of 48 zero bytes, from coreutils: head -c 48 /dev/zero | sha256sum
        assertEquals(
            "17b0761f87b081d5cf10757ccc89f12be355c70e2e29df288b65b30710dcbcd1",
            stateDigest(populationOf(Sphere())),
        )
    }

    @Test
    fun `spheres are found by id, also after some were removed`() {
        val q = p.permuted(3)
        for (k in 0 until q.size) assertEquals(k, q.indexOf(q.id[k]))
        val gone = q.id[7]
        q.retain { q.id[it] != gone }
        assertEquals(499, q.size)
        assertEquals(-1, q.indexOf(gone))
        assertEquals(-1, q.indexOf(12345))
        for (k in 0 until q.size) assertEquals(k, q.indexOf(q.id[k]))
    }

    @Test
    fun `spheres are found by id after somebody permuted the arrays`() {
        val q = p.copy()
        assertEquals(0, q.indexOf(0))
        for (a in listOf(q.x, q.y, q.z, q.vx, q.vy, q.vz, q.radius, q.mass)) a[0] = a[3].also { a[3] = a[0] }
        q.id[0] = q.id[3].also { q.id[3] = q.id[0] }
        q.orderChanged()
        assertEquals(listOf(3, 0), listOf(q.indexOf(0), q.indexOf(3)))
        assertEquals(stateDigest(p), stateDigest(q))
    }

    @Test
    fun `boxes crossed stay with the sphere when arrays are permuted, copied and thinned out`() {
        val q = p.permuted(3)
        for (k in 0 until q.size) for (axis in 0..2) q.addCrossing(k, axis, q.id[k] * (axis - 1))
        q.addCrossing(5, 0, 3)
        val moved = q.id[5]
        val copy = q.copy()
        q.retain { q.id[it] % 2 == moved % 2 }
        q.addCrossing(q.indexOf(moved), 0, 4)
        for (a in listOf(q, copy)) {
            for (id in moved % 2 until 500 step 2) {
                val added = if (id != moved) {
                    0
                } else if (a === q) {
                    7
                } else {
                    3
                }
                assertEquals(listOf(-id + added, 0, id), (0..2).map { a.boxesCrossed(id, it) })
            }
        }
        assertEquals(0, p.boxesCrossed(3, 0))
        assertEquals(stateDigest(p), stateDigest(copy)) { "not part of the digest" }
    }

    @Test
    fun `spheres that are added are found by id, with all that is known of them`() {
        val q = p.permuted(3)
        q.addCrossing(5, 0, 3)
        val crossed = q.id[5]
        q.retain { q.id[it] != 7 }
        val one = DoubleArray(2) { 1.0 + it }
        val others = Population(one, one, one, one, one, one, one, one, intArrayOf(7, Int.MAX_VALUE))
        others.addCrossing(1, 2, -4)
        others.lastCollision[0] = -0.5
        q.add(others)
        assertEquals(501, q.size)
        for (k in 0 until q.size) assertEquals(k, q.indexOf(q.id[k]))
        assertEquals(500, q.indexOf(Int.MAX_VALUE))
        assertEquals(
            listOf(3, 0, -4),
            listOf(q.boxesCrossed(crossed, 0), q.boxesCrossed(7, 2), q.boxesCrossed(Int.MAX_VALUE, 2)),
        )
        assertEquals(-0.5, q.lastCollision[499])
        assertEquals(q.id.sorted(), q.indicesById().map { q.id[it] })
        assertEquals(-1, q.indexOf(500))
    }

    @Test
    fun `a population that grew from nothing is the one that was made at once`() {
        val grown = populationOf()
        for (from in 499 downTo 0 step 125) {
            val part = p.permuted(4)
            part.retain { part.id[it] in from - 124..from }
            grown.add(part)
        }
        assertEquals(stateDigest(p), stateDigest(grown))
    }

    @Test
    fun `a sphere whose id is taken is refused and changes nothing, and one that was removed leaves no crossings`() {
        val q = p.copy()
        val two = DoubleArray(2) { 1.0 }
        fun others(vararg ids: Int) = Population(two, two, two, two, two, two, two, two, ids)
        assertThrows(IllegalArgumentException::class.java) { q.add(others(600, 499)) }
        assertThrows(IllegalArgumentException::class.java) { q.add(q) }
        assertEquals(500, q.size)
        assertEquals(-1, q.indexOf(600))
        q.addCrossing(q.indexOf(3), 1, 9)
        q.retain { q.id[it] != 3 }
        q.add(others(3, 600))
        assertEquals(0, q.boxesCrossed(3, 1))
    }

    @Test
    fun `columns for another number of spheres know of no collision, and have times that no others have`() {
        val q = populationOf(Sphere(), Sphere(x = 9.0))
        q.lastCollision[0] = 5.0
        val two = q.lastCollision
        q.take(q.columnsToWrite(tracksLastCollision = true, count = 1))
        // The arrays for two spheres are used again.
        q.take(q.columnsToWrite(tracksLastCollision = true, count = 2))
        assertEquals(listOf(Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY), q.lastCollision.asList())
        assertNotSame(two, q.lastCollision)
    }

    @Test
    fun `columns in the same order have the radii, masses and ids of the population, others have their own`() {
        val q = populationOf(Sphere(r = 1.0, m = 2.0), Sphere(x = 9.0, r = 3.0, m = 4.0))
        val radius = q.radius
        fun bodies() = listOf<Any>(q.radius, q.mass, q.id)
        fun write(columns: PopulationColumns, first: Int) {
            for (k in 0..1) {
                val from = if (k == 0) first else 1 - first
                columns.radius[k] = q.radius[from]
                columns.mass[k] = q.mass[from]
                columns.id[k] = q.id[from]
            }
            q.take(columns)
        }
        q.take(q.columnsToWrite(false, keepsOrder = true))
        assertSame(radius, q.radius)
        // Two sets of them are all that there ever is.
        val seen: MutableSet<Any> = Collections.newSetFromMap(IdentityHashMap<Any, Boolean>())
        repeat(6) { round ->
            val reversed = q.columnsToWrite(false)
            for (array in listOf(reversed.radius, reversed.mass, reversed.id)) {
                assertTrue(bodies().none { it === array }) { "round $round" }
            }
            write(reversed, first = 1)
            seen.addAll(bodies())
            repeat(round % 3) {
                val before = bodies()
                q.take(q.columnsToWrite(false, keepsOrder = true))
                assertTrue(before.zip(bodies()).all { (a, b) -> a === b })
            }
        }
        assertEquals(6, seen.size)
        assertEquals(listOf(listOf(1.0, 3.0), listOf(2.0, 4.0)), listOf(q.radius.asList(), q.mass.asList()))
        assertEquals(listOf(0, 1), q.id.asList())
    }

    @Test
    fun `a step in another order that is taken back has not written to the radii of the population`() {
        val q = populationOf(Sphere(r = 1.0), Sphere(x = 9.0, r = 3.0))
        repeat(2) { q.take(q.columnsToWrite(false, keepsOrder = true)) }
        q.beginStep()
        q.take(q.columnsToWrite(false, keepsOrder = true))
        val other = q.columnsToWrite(false)
        assertNotSame(q.radius, other.radius)
        other.radius.fill(7.0)
        q.take(other)
        // The columns of the first time, which have the radii of before.
        q.columnsToWrite(false).radius.fill(8.0)
        q.takeStepBack()
        assertEquals(listOf(1.0, 3.0), q.radius.asList())
    }

    @Test
    fun `columns that were given back are used again`() {
        val q = populationOf(Sphere(), Sphere(x = 9.0))
        val columns = q.columnsToWrite(false)
        q.giveBack(columns)
        assertSame(columns, q.columnsToWrite(false))
    }

    @Test
    fun `the granular temperature leaves out the mean and the sheared flow`() {
        val still = granularTemperature(p, null)
        val moving = p.copy()
        for (k in 0 until moving.size) {
            moving.vx[k] += 5 + 0.7 * moving.y[k]
            moving.vz[k] -= 2
        }
        assertEquals(granularTemperature(p, flow), granularTemperature(moving, flow), 1e-12)
        assertTrue(granularTemperature(moving, null) > still + 1)
        assertEquals(1.0, still, 0.1)
        assertEquals(0.0, granularTemperature(populationOf(Sphere(vx = 3.0)), flow))
    }

    @Test
    fun `what is no population is refused`() {
        assertThrows(IllegalArgumentException::class.java) { populationOf(Sphere(r = 0.0)) }
        assertThrows(IllegalArgumentException::class.java) { populationOf(Sphere(m = -1.0)) }
        assertThrows(IllegalArgumentException::class.java) { populationOf(Sphere(x = Double.NaN)) }
        val one = DoubleArray(2) { 1.0 }
        assertThrows(IllegalArgumentException::class.java) {
            Population(one, one, one, one, one, one, one, one, intArrayOf(4, 4))
        }
        assertThrows(IllegalArgumentException::class.java) {
            Population(one, one, one, one, one, one, one, DoubleArray(1))
        }
    }
}
