package daphnis.core.surface

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Laws by pair of materials. */
class MaterialLawsTest {
    private val names = listOf("ice", "rock", "iron")
    private val elastic = ConstantRestitution(1.0)
    private val sticky = ConstantRestitution(0.0)

    /** Two spheres that meet head-on with speed 2, of these materials; the velocities after. */
    private fun meet(law: ContactLaw, first: Int, second: Int): Pair<Double, Double> {
        val two = populationOf(Sphere(x = -1.0, vx = 1.0), Sphere(x = 1.0, vx = -1.0))
        val made = two.withMaterial(intArrayOf(first, second), names)
        Simulation(made, Open, CollisionForcing(law), FixedTimeStep(1.0)).use {
            it.advance()
            assertEquals(1L, it.collisions!!.counters.collisions)
            return it.population.vx[it.population.indexOf(0)] to it.population.vx[it.population.indexOf(1)]
        }
    }

    @Test
    fun `a pair has its own law in either order, and no other pair does`() {
        val law = MaterialLaws(elastic).between(1, 0, sticky)
        for (i in 0..2) {
            for (j in 0..2) {
                val (a, b) = meet(law, i, j)
                val isOwn = i + j == 1
                assertEquals(if (isOwn) 0.0 else -1.0, a, 1e-14) { "$i, $j" }
                assertEquals(if (isOwn) 0.0 else 1.0, b, 1e-14) { "$i, $j" }
            }
        }
        // Like spheres may have one, and a law that is given again replaces the former.
        val like = law.between(2, 2, sticky).between(0, 1, elastic)
        assertEquals(0.0, meet(like, 2, 2).first, 1e-14)
        assertEquals(-1.0, meet(like, 0, 1).first, 1e-14)
        assertEquals(elastic, like.others)
        assertEquals(0.0, meet(law, 0, 1).first, 1e-14) { "the former table stays as it was" }
        assertThrows(IllegalArgumentException::class.java) { law.between(0, -1, sticky) }
    }

    @Test
    fun `the material of the sphere with the lower id is the first`() {
        val seen = ArrayList<Pair<Int, Int>>()
        val law = object : ContactLaw {
            override val isRough get() = false
            override fun restitution(contact: SurfaceContact): Double {
                seen += contact.firstMaterial to contact.secondMaterial
                return 1.0
            }
        }
        meet(law, 2, 1)
        meet(law, 0, 2)
        assertEquals(listOf(2 to 1, 0 to 2), seen)
    }

    @Test
    fun `impulses between unlike spheres with ε = 0 leave like ones elastic`() {
        val boundary = Periodic(Box.centred(8.0, 8.0, 8.0))
        val made = randomSpheres(200, boundary, 5, 1.0) { 0.4 }.withMaterial(IntArray(200) { it % 2 }, listOf("a", "b"))
        val law = MaterialLaws(elastic).between(0, 1, sticky)
        val forcing = CollisionForcing(law, FloorSpeedGuard(1e-9), recordCollisions = true)
        var like = 0
        var unlike = 0
        Simulation(made, boundary, forcing, FixedTimeStep(0.02)).use {
            repeat(60) { _ ->
                it.advance()
                val record = it.collisions!!.record!!
                for (k in 0 until record.size) {
                    val isLike = (record.lower[k] + record.higher[k]) % 2 == 0
                    // The guard has made it elastic.
                    if (record.impactSpeed(k) < 1e-9) continue
                    if (isLike) like++ else unlike++
                    assertEquals(if (isLike) 1.0 else 0.0, record.coefficient(k))
                }
            }
        }
        assertTrue(like > 100 && unlike > 100) { "$like, $unlike" }
    }

    @Test
    fun `materials alone change nothing, and a table of one law gives its bits`() {
        val boundary = Periodic(Box.centred(8.0, 8.0, 8.0))
        fun gas() = randomSpheres(300, boundary, 6, 1.0) { it.nextDouble(0.2, 0.5) }
        fun made() = gas().withMaterial(IntArray(300) { it % 3 }, names)
        fun end(p: Population, law: ContactLaw) =
            Simulation(p, boundary, CollisionForcing(law, FloorSpeedGuard(1e-9)), FixedTimeStep(0.05)).use {
                repeat(30) { _ -> it.advance() }
                stateDigest(it.population)
            }
        val law = Restitution { 1 / (1 + it) }
        val plain = end(gas(), law)
        assertEquals(plain, end(made(), law))
        assertEquals(plain, end(made(), MaterialLaws(law)))
        assertEquals(plain, end(gas(), MaterialLaws(law).between(1, 2, sticky)))
        assertNotEquals(plain, end(made(), MaterialLaws(law).between(1, 2, sticky)))
    }

    private fun rough(law: ContactLaw, first: Int, second: Int): Double {
        val two = populationOf(Sphere(x = -1.0, vx = 1.0, vy = 0.25), Sphere(x = 1.0, vx = -1.0, vy = 0.25))
        val zero = DoubleArray(2)
        val made = two.withMaterial(intArrayOf(first, second), names).withSpin(zero, zero, doubleArrayOf(1.0, 0.0))
        return Simulation(made, Open, CollisionForcing(law), FixedTimeStep(1.0)).use {
            it.advance()
            it.population.wz[it.population.indexOf(1)]
        }
    }

    @Test
    fun `surfaces are as rough as their pair is, also where others are smooth`() {
        assertFalse(MaterialLaws(elastic).between(0, 1, sticky).isRough)
        val grip = RoughContact(elastic, ConstantRoughness(0.5))
        val tables = listOf(
            MaterialLaws(elastic).between(0, 1, grip),
            RoughContact(elastic, MaterialRoughness(null).between(0, 1, ConstantRoughness(0.5))),
        )
        for (law in tables) {
            assertTrue(law.isRough)
            assertEquals(rough(grip, 0, 0), rough(law, 1, 0))
            assertTrue(rough(law, 0, 1) != 0.0)
            assertEquals(0.0, rough(law, 1, 1))
            assertEquals(0.0, rough(law, 2, 0))
        }
        val smoothPair = RoughContact(elastic, MaterialRoughness(ConstantRoughness(0.5)).between(1, 1, null))
        assertEquals(0.0, rough(smoothPair, 1, 1))
        assertEquals(rough(grip, 0, 0), rough(smoothPair, 1, 2))
    }

    @Test
    fun `coefficients are those of the pair to the last digit`() {
        val contact = SurfaceContact.headOn(2.0, 1.0, 1.0, material = 1)
        val near = ConstantRoughness(-1.0 + 1e-9)
        assertEquals(near.change(contact), MaterialRoughness(null).between(1, 1, near).change(contact))
        assertEquals(-1.0, MaterialRoughness(null).coefficient(contact))
        val coulomb = RoughContact(sticky, CoulombRoughness(1e-12, 0.5))
        contact.tangentialSpeed = 1.0
        contact.restitution = 0.0
        assertEquals(coulomb.change(contact), MaterialLaws(elastic).between(1, 1, coulomb).change(contact))
        assertEquals(0.0, MaterialLaws(elastic).between(1, 1, coulomb).restitution(contact))
        assertEquals(-1.0, MaterialLaws(elastic).roughness(contact))
    }
}
