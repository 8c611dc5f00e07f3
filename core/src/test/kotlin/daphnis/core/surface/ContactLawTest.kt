package daphnis.core.surface

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.boundary.prepare
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.ContactDurationGuard
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.NoGuard
import daphnis.core.collision.StepRows
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.space.Images
import daphnis.core.wall.WallContact
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

/** Laws of both coefficients. */
class ContactLawTest {
    private val still = Images().apply { prepare(Open, 0.0) }

    /** A law that writes down what it is told. */
    private class Noting(
        override val isRough: Boolean,
        val e: (SurfaceContact) -> Double,
        val b: (SurfaceContact) -> Double = { error("is asked for β") },
    ) : ContactLaw {
        val told = ArrayList<List<Double>>()

        override fun restitution(contact: SurfaceContact) = e(contact).also { note(contact) }

        override fun roughness(contact: SurfaceContact) = b(contact).also { note(contact) }

        private fun note(c: SurfaceContact) {
            told += listOf(
                c.normalSpeed, c.tangentialSpeed, c.restitution, c.firstRadius, c.secondRadius, c.firstMass,
                c.secondMass, 1.0 * c.firstMaterial, 1.0 * c.secondMaterial, c.momentFactor,
            )
        }
    }

    private val apart =
        listOf(Sphere(vx = 3.0, vy = 1.0, vz = -2.0, r = 0.5, m = 2.0), Sphere(x = 2.0, r = 1.5, m = 6.0))
    private val pair = populationOf(*apart.toTypedArray())
    private val spinning = pair.withSpin(doubleArrayOf(0.0, 0.0), doubleArrayOf(0.0, 0.0), doubleArrayOf(2.0, 4.0))

    private fun rows(p: Population) = StepRows().apply { load(p, IntArray(p.size) { it }, 1.0, false) }

    private fun CollisionLaw.hit(p: Population, one: Int = 0, other: Int = 1): StepRows {
        val rows = rows(p)
        assertTrue(collide(rows, one, other, 0, still, 0.0, CollisionOutcome()))
        return rows
    }

    private fun StepRows.velocities() = List(6) { state[it / 3 * StepRows.STRIDE + StepRows.VX + it % 3] }

    @Test
    fun `a smooth law is told of everything, without spins and with them, and asked for one coefficient`() {
        for (p in listOf(pair, spinning)) {
            for ((one, other) in listOf(0 to 1, 1 to 0)) {
                val law = Noting(isRough = false, { 0.75 })
                val rows = CollisionLaw(law, momentFactor = 0.5).hit(p, one, other)
                // By spins the surfaces move with 0.5 · 2 + 1.5 · 4 along −y, in the frame of the second.
                val slidingY = if (p.hasSpin) 1.0 + 7.0 else 1.0
                val sliding = sqrt(slidingY * slidingY + 4.0)
                val told = listOf(3.0, sliding, Double.NaN, 0.5, 1.5, 2.0, 6.0, 0.0, 0.0, 0.5)
                assertEquals(listOf(told), law.told)
                // Σ m v = 6, and the first goes back with 3/4 of the relative speed.
                assertEquals(listOf(0.75 - 0.75 * 2.25, 1.0, -2.0, 0.75 + 0.25 * 2.25, 0.0, 0.0), rows.velocities())
                if (p.hasSpin) assertEquals(listOf(2.0, 4.0), listOf(rows.wz[0], rows.wz[1]))
            }
        }
    }

    @Test
    fun `a rough law is asked for the second coefficient with the first in hand, unless nothing slides`() {
        val law = Noting(isRough = true, { 0.75 }, { -it.restitution })
        CollisionLaw(law, momentFactor = 0.5).hit(spinning)
        assertEquals(listOf(Double.NaN, 0.75), law.told.map { it[2] })
        assertEquals(law.told[0] - Double.NaN, law.told[1] - 0.75)
        val guarded = Noting(isRough = true, { error("is asked for ε") }, { 0.0 })
        CollisionLaw(guarded, FloorSpeedGuard(3.5)).hit(spinning)
        assertEquals(listOf(1.0), guarded.told.map { it[2] })
        val straight = Noting(isRough = true, { 0.75 })
        val none = DoubleArray(2)
        CollisionLaw(straight).hit(populationOf(Sphere(vx = 1.0), Sphere(x = 2.0)).withSpin(none, none, none))
        assertEquals(1, straight.told.size)
    }

    private fun cooled(guard: CollapseGuard, law: ContactLaw, roughness: Roughness? = null): Pair<String, Long> {
        val boundary = Periodic(Box.centred(10.0, 10.0, 10.0))
        val p = randomSpheres(300, boundary, 8, 1.0) { 0.3 + 0.4 * it.nextDouble() }
        val w = DoubleArray(p.size) { 0.3 * (it % 5 - 2) }
        val spinning = p.withSpin(w, w, w)
        val forcing = CollisionForcing(law, guard, roughness = roughness, momentFactor = 0.3)
        Simulation(spinning, boundary, forcing, FixedTimeStep(0.1)).use { s -> repeat(10) { s.advance() } }
        assertTrue(forcing.counters.collisions > 100)
        return stateDigest(spinning) to forcing.counters.guardActivations
    }

    @Test
    fun `what says the same has the same bits, by one law or two, under each guard`() {
        val guards = listOf(NoGuard, FloorSpeedGuard(0.5), ContactDurationGuard(0.02))
        for (guard in guards) {
            val smooth = cooled(guard, ConstantRestitution(0.7))
            assertEquals(smooth, cooled(guard, Noting(isRough = false, { 0.7 })))
            assertEquals(guard == NoGuard, smooth.second == 0L)
            val friction = CoulombRoughness(0.4, 0.2)
            val rough = cooled(guard, ConstantRestitution(0.7), friction)
            assertTrue(rough != smooth)
            assertEquals(rough, cooled(guard, RoughContact(ConstantRestitution(0.7), friction)))
            assertEquals(rough, cooled(guard, Noting(isRough = true, { 0.7 }), friction))
            val both = object : ContactLaw {
                override val isRough get() = true

                override fun restitution(contact: SurfaceContact) = 0.7

                override fun roughness(contact: SurfaceContact) = friction.coefficient(contact)

                override fun change(contact: SurfaceContact) = friction.change(contact)
            }
            assertEquals(rough, cooled(guard, both))
        }
    }

    @Test
    fun `a law that is rough needs spins, and one that leaves its range ends the step`() {
        fun advance(p: Population, law: ContactLaw) {
            val steps = FixedTimeStep(0.5)
            Simulation.builder(p.copy()).boundary(Open).contactLaw(law).timeStep(steps).build().use { it.advance() }
        }

        fun refused(p: Population, law: ContactLaw) =
            assertThrows(IllegalArgumentException::class.java) { advance(p, law) }.message!!
        assertTrue("no angular velocities" in refused(pair, Noting(isRough = true, { 1.0 }, { 0.0 })))
        advance(pair, Noting(isRough = false, { 1.0 }))
        for (p in listOf(pair, spinning)) {
            for (bad in listOf(1.5, -0.5, Double.NaN)) {
                assertEquals(
                    "the coefficient of restitution is $bad at an impact speed of 3.0; it must be in [0, 1]",
                    refused(p, Noting(isRough = false, { bad })),
                )
            }
        }
        val nan = refused(spinning, Noting(isRough = true, { 1.0 }, { Double.NaN }))
        assertTrue(nan.startsWith("the coefficient of tangential restitution is NaN where surfaces slide at ")) { nan }
    }

    @Test
    fun `an outcome keeps nothing of surfaces that do not rub, and both spheres the time of the impact`() {
        val outcome = CollisionOutcome()
        val rough = CollisionLaw(Noting(isRough = true, { 0.75 }, { 0.0 }))
        assertTrue(rough.collide(rows(spinning), 0, 1, 0, still, 0.0, outcome))
        assertTrue(outcome.rubbed > 0 && outcome.slideY != 0.0)
        val smooth = CollisionLaw(Noting(isRough = false, { 0.75 }), ContactDurationGuard(0.1))
        val rows = StepRows().apply { load(spinning, intArrayOf(0, 1), 1.0, true) }
        assertTrue(smooth.collide(rows, 0, 1, 0, still, 0.25, outcome))
        assertEquals(listOf(0.0, 0.0, 0.0, 0.0), with(outcome) { listOf(slideX, slideY, slideZ, rubbed) })
        assertEquals(listOf(0.25, 0.25), List(2) { rows.lastCollision[it] })
    }

    @Test
    fun `a wall is infinite and of no material`() {
        var told = emptyList<Double>()
        val law = Roughness { c ->
            told = listOf(1.0 * c.firstMaterial, 1.0 * c.secondMaterial, c.effectiveRadius, c.reducedMass)
            -1.0
        }
        val walls = Walls(Box.centred(8.0, 8.0, 8.0), roughness = List(6) { law })
        val contact = WallContact().apply { prepare(walls.walls, CollisionLaw(ConstantRestitution(1.0))) }
        contact.reflect(rows(spinning), 0, 1, 0.0, CollisionOutcome())
        assertEquals(listOf(0.0, -1.0, 0.5, 2.0), told)
    }

    @Test
    fun `of a pair the radius is the effective one, and the mass the reduced one`() {
        val law = Noting(isRough = false, { it.effectiveRadius / it.reducedMass })
        CollisionLaw(law).hit(pair).let {
            // (3/8) / (3/2) = 1/4.
            assertEquals(0.75 - 0.75 * 0.75, it.velocities()[0])
        }
    }
}
