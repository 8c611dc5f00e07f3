package daphnis.core.engine

import daphnis.core.Sphere
import daphnis.core.assertInvariants
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.ContactDurationGuard
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.NoGuard
import daphnis.core.hill.HillSheet
import daphnis.core.initial.Lattice
import daphnis.core.initial.LatticePlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.permuted
import daphnis.core.population.Conserved
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.queue.ReferenceEventQueue
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.step.CollapseException
import daphnis.core.surface.BridgesRestitution
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SerialEngineTest {
    @Test
    fun `a fast pair bounces within one step, where the paths cross`() {
        val p = populationOf(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, vx = -10.0))
        val simulation = simulationOf(p, Open, 1.0)
        simulation.advance()
        assertEquals(1L, simulation.collisions!!.counters.collisions)
        assertEquals(0.4, simulation.collisions.record!!.time[0], 1e-15)
        assertEquals(-7.0, p.x[p.indexOf(0)], 1e-14)
        assertEquals(7.0, p.x[p.indexOf(1)], 1e-14)
    }

    @Test
    fun `a pair that misses by a hair flies on`() {
        val p = populationOf(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, y = 2.0 + 1e-9, vx = -10.0))
        val simulation = simulationOf(p, Open, 1.0)
        simulation.advance()
        assertEquals(0L, simulation.collisions!!.counters.collisions)
        assertEquals(5.0, p.x[p.indexOf(0)], 1e-14)
    }

    @Test
    fun `Newton's cradle passes the velocity on`() {
        val p = populationOf(Sphere(x = 0.0, vx = 1.0), Sphere(x = 4.0), Sphere(x = 8.0))
        val simulation = simulationOf(p, Open, 10.0)
        simulation.advance()
        assertEquals(2L, simulation.collisions!!.counters.collisions)
        assertEquals(1.0, p.vx[p.indexOf(2)], 1e-15)
        assertEquals(2.0, p.x[p.indexOf(0)], 1e-14)
        assertEquals(6.0, p.x[p.indexOf(1)], 1e-14)
        assertEquals(14.0, p.x[p.indexOf(2)], 1e-14)
    }

    @Test
    fun `a collision takes away what was queued for later`() {
        // The first would hit the third at t = 4; the second knocks it aside at t = 1.
        val p = populationOf(Sphere(vx = 1.0), Sphere(x = 1.0, y = 3.0, vy = -1.0), Sphere(x = 6.0))
        val simulation = simulationOf(p, Open, 20.0)
        simulation.advance()
        assertEquals(0.0, p.vx[p.indexOf(2)])
        assertEquals(1L, simulation.collisions!!.counters.collisions)
    }

    @Test
    fun `spheres meet through periodic faces`() {
        val p = populationOf(Sphere(x = 5.0, vx = 1.0, r = 0.5), Sphere(x = -5.0, r = 0.5))
        val simulation = simulationOf(p, Periodic(Box.centred(12.0, 12.0, 12.0)), 2.0)
        simulation.advance()
        assertEquals(1L, simulation.collisions!!.counters.collisions)
        assertEquals(1.0, p.vx[p.indexOf(1)], 1e-15)
    }

    @Test
    fun `the paper's box does not look through its faces`() {
        val p = populationOf(Sphere(x = 5.0, vx = 0.4, r = 0.5), Sphere(x = -5.0, r = 0.5))
        val simulation = simulationOf(p, ShearedPeriodic(Box.centred(12.0, 12.0, 12.0), 0.0), 2.0)
        simulation.advance()
        assertEquals(0L, simulation.collisions!!.counters.collisions)
    }

    @Test
    fun `a wall reflects at the surface of the sphere and takes its share of the speed`() {
        val p = populationOf(Sphere(x = 3.0, vx = 2.0))
        val simulation = simulationOf(p, Walls(Box.centred(10.0, 10.0, 10.0), 0.5), 2.0)
        simulation.advance()
        // Wall at 5, surface at 4: contact at t = 0.5, then back with speed 1 for 1.5.
        assertEquals(2.5, p.x[0], 1e-15)
        assertEquals(-1.0, p.vx[0])
        assertEquals(1L, simulation.collisions!!.counters.wallCollisions)
    }

    @Test
    fun `three on a line collapse for a coefficient below 7 − 4√3, and the guard ends it`() {
        for ((e, collapses) in listOf(0.06 to true, 0.08 to false)) {
            for (guard in listOf(FloorSpeedGuard(1e-9), ContactDurationGuard(1e-6))) {
                val p = populationOf(Sphere(x = 0.0, vx = 1.0), Sphere(x = 3.0), Sphere(x = 6.5, vx = -1.0))
                val simulation = simulationOf(p, Open, 100.0, ConstantRestitution(e), guard)
                simulation.advance()
                assertEquals(collapses, simulation.collisions!!.counters.guardActivations > 0) {
                    "e = $e, ${guard.javaClass.simpleName}"
                }
                assertInvariants(simulation)
            }
        }
    }

    @Test
    fun `without a guard a collapse of three ends by round-off, in contact and at rest to one another`() {
        val p = populationOf(Sphere(x = 0.0, vx = 1.0), Sphere(x = 3.0), Sphere(x = 6.5, vx = -1.0))
        val simulation = simulationOf(p, Open, 100.0, ConstantRestitution(0.06))
        simulation.advance()
        val record = simulation.collisions!!.record!!
        assertTrue(record.size in 30..60) { "${record.size} collisions" }
        assertTrue(record.impactSpeed(record.size - 1) < 1e-15)
        for (id in 0..1) {
            val a = p.indexOf(id)
            val b = p.indexOf(id + 1)
            assertEquals(0.0, p.vx[b] - p.vx[a], 1e-15)
            assertEquals(2.0, p.x[b] - p.x[a], 1e-13)
        }
        // With a coefficient above 7 − 4√3 they part after a few.
        val parting =
            simulationOf(
                populationOf(Sphere(x = 0.0, vx = 1.0), Sphere(x = 3.0), Sphere(x = 6.5, vx = -1.0)),
                Open,
                100.0,
                ConstantRestitution(0.08),
            )
        parting.advance()
        assertTrue(parting.collisions!!.record!!.let { it.impactSpeed(it.size - 1) } > 1e-12)
    }

    @Test
    fun `without a guard a collapse of many is noticed, and the population is as it was`() {
        // Forty in a row, all closing in on the middle.
        val spheres = Array(40) { Sphere(x = 2.0001 * it, vx = (20 - it) * 1.0, r = 1.0) }
        val p = populationOf(*spheres)
        val before = stateDigest(p)
        val simulation = simulationOf(p, Open, 100.0, ConstantRestitution(0.2))
        assertThrows(CollapseException::class.java) { simulation.advance() }
        assertEquals(before, stateDigest(p))
    }

    @Test
    fun `a sphere that outruns the bound makes the step be redone, and no contact is missed`() {
        // A heavy one hits a light one, which leaves with nearly twice the speed and reaches a third within the step.
        val p =
            populationOf(
                Sphere(x = 0.0, vx = 1.0, m = 1000.0, r = 0.5),
                Sphere(x = 2.0, m = 0.001, r = 0.5),
                Sphere(x = 30.0, r = 0.5),
            )
        val q = p.copy()
        val simulation = simulationOf(p, Open, 20.0)
        simulation.advance()
        assertTrue(simulation.collisions!!.counters.redoneSteps > 0)
        simulationOf(q, Open, 20.0, engine = BruteForceEngine()).advance()
        assertEquals(stateDigest(q), stateDigest(p))
        assertTrue(p.vx[p.indexOf(2)] > 0)
    }

    @Test
    fun `every step has the digest of the engine that asks every pair`() {
        for (seed in 1L..DRAWS) compareWithBruteForce(seed)
    }

    private fun compareWithBruteForce(seed: Long) {
        val random = SeededRandom(seed)
        val flat = random.nextInt(3) == 0
        val box = Box.centred(5 + random.nextDouble() * 5, 5 + random.nextDouble() * 5, if (flat) 2.1 else 5.0)
        val boundaries = listOf<BoundaryConditions>(
            Open,
            Periodic(box),
            Periodic(box, true, false, false),
            Walls(box, 0.9),
            Walls(box, 1.0, booleanArrayOf(false, true, false)),
            ShearedPeriodic(box, 0.7),
            LeesEdwards(box, 0.3),
            LeesEdwards(box, -1.1),
            HillSheet(box, 0.2),
            HillSheet(box, 0.2, radiallyOpen = true),
        )
        val boundary = boundaries[random.nextInt(boundaries.size)]
        val smallest = if (random.nextInt(2) == 0) 0.1 else 0.5
        val p = randomSpheres(1 + random.nextInt(25), boundary, seed, 1.0) { it.nextDouble(smallest, 1.0) * 0.8 }
        val dt = Math.pow(10.0, random.nextDouble(-2.0, 0.2))
        val restitution = listOf(
            ConstantRestitution(1.0),
            ConstantRestitution(0.7),
            BridgesRestitution(),
        )[random.nextInt(3)]
        val guard = listOf(NoGuard, FloorSpeedGuard(1e-3), ContactDurationGuard(1e-2))[random.nextInt(3)]
        val slow = simulationOf(p.permuted(seed), boundary, dt, restitution, guard, BruteForceEngine())
        val fast = simulationOf(p, boundary, dt, restitution, guard)
        val story = "seed $seed: ${p.size} spheres, ${boundary.javaClass.simpleName}, dt $dt"
        for (k in 1..8) {
            // Elastic spheres under shear heat up without end, and the slow engine asks every image they could reach.
            if (listOf(p.vx, p.vy, p.vz).any { v -> v.maxOf { Math.abs(it) } * dt > 12 }) return
            slow.advance()
            fast.advance()
            assertEquals(stateDigest(slow.population), stateDigest(fast.population)) { "$story, step $k" }
            val a = slow.collisions!!.counters
            val b = fast.collisions!!.counters
            assertEquals(
                listOf(a.collisions, a.wallCollisions, a.guardActivations),
                listOf(b.collisions, b.wallCollisions, b.guardActivations),
            ) {
                story
            }
            if (boundary !is ShearedPeriodic) assertInvariants(fast)
        }
    }

    @Test
    fun `a symmetric lattice of simultaneous collisions gives one digest in whatever order it is given`() {
        val box = Box.centred(8.0, 8.0, 8.0)
        val radii = DoubleArray(64) { 0.4 }
        val places = LatticePlacement(Lattice.SIMPLE_CUBIC).place(radii, box, BooleanArray(3), SeededRandom(1))
        val spheres = Array(64) { k ->
            // Neighbours along x close in on each other with the same speed: very many events at the same time.
            val odd = (Math.rint(places.x[k] - 1).toInt() / 2 + Math.rint(places.y[k] - 1).toInt() / 2) and 1
            Sphere(
                places.x[k],
                places.y[k],
                places.z[k],
                vx = if (odd == 1) 1.0 else -1.0,
                vy = if (odd == 1) 0.5 else -0.5,
                r = 0.4,
            )
        }
        val digests = (0L..5L).map { seed ->
            val p = populationOf(*spheres).permuted(seed)
            val queue = if (seed % 2 == 0L) daphnis.core.queue.BucketEventQueue() else ReferenceEventQueue()
            val simulation = simulationOf(p, Periodic(box), 0.7, ConstantRestitution(0.9), engine = SerialEngine(queue))
            repeat(10) { simulation.advance() }
            assertTrue(simulation.collisions!!.counters.collisions >= 64) {
                "only ${simulation.collisions.counters.collisions} collisions"
            }
            stateDigest(p)
        }
        assertEquals(1, digests.toSet().size)
    }

    @Test
    fun `one sphere alone goes straight, none at all is no trouble`() {
        val p = populationOf(Sphere(vx = 1.0))
        val simulation = simulationOf(p, Periodic(Box.centred(10.0, 10.0, 10.0)), 2.5)
        repeat(4) { simulation.advance() }
        assertEquals(0.0, p.x[0], 1e-15)
        assertEquals(0L, simulation.collisions!!.counters.collisions)
        simulationOf(populationOf(), Periodic(Box.centred(10.0, 10.0, 10.0)), 1.0).advance()
        simulationOf(populationOf(), Open, 1.0).advance()
    }

    @Test
    fun `momentum and, when elastic, energy are conserved with sizes 1 to 10`() {
        val boundary = Periodic(Box.centred(20.0, 20.0, 20.0))
        val p = randomSpheres(300, boundary, 3, 1.0) { it.nextDouble(0.1, 1.0) }
        val before = Conserved.of(p)
        val simulation = simulationOf(p, boundary, 0.2)
        repeat(100) {
            simulation.advance()
            assertInvariants(simulation)
        }
        val after = Conserved.of(p)
        assertTrue(simulation.collisions!!.counters.collisions > 1000)
        assertEquals(before.kineticEnergy, after.kineticEnergy, before.kineticEnergy * 1e-13)
        assertEquals(before.momentumX, after.momentumX, 1e-12 * before.mass)
    }

    private companion object {
        const val DRAWS = 250L
    }
}
