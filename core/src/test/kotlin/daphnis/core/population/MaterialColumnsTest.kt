package daphnis.core.population

import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.cluster.Mail
import daphnis.core.cluster.MailRoom
import daphnis.core.cluster.SpheresWire
import daphnis.core.cluster.bricks.BrickSpheres
import daphnis.core.cluster.bricks.IndexRuns
import daphnis.core.cluster.bricks.PathHash
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The column of materials, which a population has or has not. */
class MaterialColumnsTest {
    private val plain = randomSpheres(20, Periodic(Box.centred(9.0, 9.0, 9.0)), 3, 1.0) { 0.4 }
    private val names = listOf("ice", "rock", "iron")

    private fun made(p: Population = plain) = p.withMaterial(IntArray(p.size) { p.id[it] % 3 }, names)

    private fun spun(p: Population) = DoubleArray(p.size) { 1.0 }.let { p.withSpin(it, it, it) }

    @Test
    fun `materials go with their spheres, with spins and without`() {
        for (p in listOf(made(), spun(made()), made(spun(plain)))) {
            p.retain { p.id[it] % 4 != 0 }
            p.drift(0.5)
            val copy = p.copy()
            assertEquals(names, copy.materials)
            assertTrue(copy.hasMaterials && copy.size == 15)
            for (k in 0 until copy.size) assertEquals(copy.id[k] % 3.0, copy.material[k])
        }
        assertTrue(spun(made()).hasSpin && spun(made()).hasMaterials)
    }

    @Test
    fun `spheres without materials have no column, and none is made when they are copied, joined or moved`() {
        for (p in listOf(plain.copy(), spun(plain))) {
            p.add(randomSpheres(0, Periodic(Box.centred(9.0, 9.0, 9.0)), 3, 1.0) { 0.4 })
            p.retain { it > 4 }
            p.drift(0.5)
            val hidden = PopulationColumns(p.size, PopulationColumns.joined(listOf(p)))
            hidden.fixed = hidden.fixed.empty(7)
            for (q in listOf(p, hidden)) {
                assertFalse(q.hasMaterials)
                assertSame(SphereQuantity.NONE, q.material)
            }
            assertEquals(emptyList<String>(), p.materials)
        }
    }

    @Test
    fun `the digest is that of the motion, whatever spheres are made of`() {
        assertEquals(stateDigest(plain), stateDigest(made()))
        assertEquals(stateDigest(spun(plain)), stateDigest(spun(made())))
    }

    @Test
    fun `spheres that are added have the same materials or none, which is the first`() {
        fun others() = plain.copy().also { p -> for (k in 0 until p.size) p.id[k] += 100 }.let {
            Population(it.x, it.y, it.z, it.vx, it.vy, it.vz, it.radius, it.mass, it.id)
        }
        val p = made()
        p.add(others())
        assertEquals(0.0, p.material[p.indexOf(107)])
        p.add(made(others().also { q -> for (k in 0 until q.size) q.id[k] += 100 }.copyAnew()))
        assertEquals(208 % 3.0, p.material[p.indexOf(208)])
        assertThrows(IllegalArgumentException::class.java) { plain.copy().add(made(others())) }
        val e = assertThrows(IllegalArgumentException::class.java) {
            made().add(others().withMaterial(IntArray(20), listOf("ice")))
        }
        assertTrue("[ice]; they must be [ice, rock, iron], as" in e.message!!) { e.message }
    }

    private fun Population.copyAnew() = Population(x, y, z, vx, vy, vz, radius, mass, id)

    @Test
    fun `names are words that every file can hold, and numbers are those of names`() {
        fun refused(numbers: IntArray, vararg names: String) = assertThrows(IllegalArgumentException::class.java) {
            plain.withMaterial(numbers, names.asList())
        }.message.orEmpty()
        assertEquals("material '' must be a word of at most 64 letters, digits, _ and -", refused(IntArray(20), ""))
        assertTrue("'a b'" in refused(IntArray(20), "ice", "a b"))
        assertTrue("occurs twice" in refused(IntArray(20), "ice", "ice"))
        assertTrue("no material is named" in refused(IntArray(20)))
        assertTrue("is 1.0; it must be a whole number below 1" in refused(IntArray(20) { it / 19 }, "ice"))
        assertTrue("is -1.0" in refused(IntArray(20) { it / 19 - 1 }, "ice"))
        assertTrue("material has 19 entries" in refused(IntArray(19), "ice"))
    }

    @Test
    fun `a builder takes materials`() {
        val zero = DoubleArray(2)
        fun builder() = Population.builder().positions(doubleArrayOf(0.0, 3.0), zero, zero).radius(1.0).mass(1.0)
        val p = builder().materials(intArrayOf(1, 0), listOf("ice", "rock")).spins(zero, zero, zero).build()
        assertArrayEquals(doubleArrayOf(1.0, 0.0), p.material)
        assertEquals(listOf("ice", "rock"), p.materials)
        assertTrue(p.hasSpin)
        assertFalse(builder().build().hasMaterials)
    }

    @Test
    fun `messages and the spheres of a node have materials where there are any`() {
        for (p in listOf(plain, made(), spun(plain), spun(made()))) {
            for (until in listOf(0, 7)) {
                val room = MailRoom(1)
                SpheresWire.send(room.mail(Mail.LEADER), 0, p, 0, until)
                val part = Population(SpheresWire.receive(room.mail(0), Mail.LEADER), emptyList())
                assertEquals(until, part.size)
                assertEquals(p.optional, part.optional)
                if (p.hasMaterials) assertArrayEquals(p.material.copyOf(until), part.material)
            }
            val brick = BrickSpheres()
            val all = IndexRuns().also { for (k in 0 until p.size) it.add(k) }
            repeat(2) {
                brick.begin(p.size)
                brick.add(p, all, true)
                brick.settle()
                assertEquals(p.optional, brick.optional)
                if (p.hasMaterials) assertArrayEquals(p.material, brick.material.copyOf(p.size))
            }
            if (!p.hasMaterials) continue
            val hash = PathHash.whole(0L, p, 3, false)
            p.material[3] += 1.0
            assertNotEquals(hash, PathHash.whole(0L, p, 3, false))
        }
    }

    @Test
    fun `partial temperatures are energies without the flow and the mean, and bodies have none`() {
        val zero = DoubleArray(4)
        val p = Population(
            zero.copyOf(),
            doubleArrayOf(1.0, -1.0, 1.0, -1.0),
            zero.copyOf(),
            doubleArrayOf(3.0, 1.0, 2.0, 9.0),
            zero.copyOf(),
            zero.copyOf(),
            DoubleArray(4) { 0.1 },
            doubleArrayOf(1.0, 1.0, 2.0, 50.0),
        ).withMaterial(intArrayOf(0, 0, 1, 2), names)
        // v_x = ½ y of the flow: without it 5/2, 3/2, 3/2, of which the mean is 7/4.
        val flow = MeanFlow(normalAxis = 1, flowAxis = 0, rate = 0.5)
        val sums = PopulationSums(flow, firstBody = 3).also { it.take(p) }
        val byMaterial = MaterialSums(names, flow, firstBody = 3)
        byMaterial.take(p, sums)
        assertEquals((0.75 * 0.75 + 0.25 * 0.25) / 2 / 3, byMaterial.temperature(0), 1e-15)
        assertEquals(2 * 0.25 * 0.25 / 3, byMaterial.temperature(1), 1e-15)
        assertTrue(byMaterial.temperature(2).isNaN())
        assertEquals(listOf(2L, 1L, 0L), List(3) { byMaterial.count(it) })
        byMaterial.take(plain, PopulationSums(Open.meanFlow).also { it.take(plain) })
        assertTrue(byMaterial.temperature(0).isNaN())
    }
}
