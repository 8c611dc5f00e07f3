package daphnis.core.engine.horizon

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.ContactDurationGuard
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.Draws
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.force.Kick
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.populationOf
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/** Bodies among small spheres, which they pull and on which these come to lie. */
class GiantsTest {
    private class Draw(private val seed: Long) {
        private val random = SeededRandom(seed)
        private val giants = 1 + (seed % 3).toInt()
        private val box = Box.centred(EDGE, EDGE, EDGE)

        /** Some are hardly moved by what falls on them, others a lot. */
        private val mass = listOf(1e7, 1e4, 300.0, 20.0)[(seed / 3 % 4).toInt()]
        private val boundary: BoundaryConditions = when (seed % 5) {
            0L -> Open
            1L -> Walls(box, 0.8)
            2L -> ShearedPeriodic(box, 0.3)
            else -> Periodic(box)
        }
        private val pull = random.nextDouble(0.1, 0.6)
        private val dt = random.nextDouble(0.02, 0.2)

        // Beside a face, so that what the first one meets are images as often as not; the others are near each other.
        private val bodies = List(giants) {
            val at = if (it == 0) EDGE / 2 - 1.85 else -2.0 - 3.7 * (it - 1)
            Sphere(at, 0.2 * it, at, vx = 0.3 * it, vz = if (it == 0) 0.1 else -0.1, r = RADIUS, m = mass)
        }

        private fun start() = populationOf(
            *bodies.toTypedArray(),
            *(0 until SIDE * SIDE * SIDE).map { c ->
                fun at(k: Int) = (k - SIDE / 2 + 0.5) * EDGE / SIDE
                val x = at(c % SIDE)
                val y = at(c / SIDE % SIDE)
                val z = at(c / SIDE / SIDE)
                fun speed() = random.nextDouble(-0.3, 0.3)
                Sphere(x, y, z, speed(), speed(), speed(), r = SMALL, m = 1.0)
            }.filter { s -> bodies.all { distance(s.x - it.x, s.y - it.y, s.z - it.z) > RADIUS + 2 * SMALL } }
                .toTypedArray(),
        )

        private val spheres = start()

        fun simulation(engine: CollisionEngine): Simulation {
            val fall = Kick { p, _, duration ->
                val one = p.indexOf(0)
                for (k in 0 until p.size) {
                    if (p.id[k] < giants) continue
                    val dx = wrapped(p.x[one] - p.x[k])
                    val dy = wrapped(p.y[one] - p.y[k])
                    val dz = wrapped(p.z[one] - p.z[k])
                    val d = distance(dx, dy, dz)
                    p.vx[k] += pull * duration * dx / d
                    p.vy[k] += pull * duration * dy / d
                    p.vz[k] += pull * duration * dz / d
                }
            }
            val guard = ContactDurationGuard(1e-3)
            val collisions = CollisionForcing(ConstantRestitution(0.5), guard, engine, recordCollisions = true)
            return Simulation(spheres.copy(), boundary, collisions, FixedTimeStep(dt), listOf(fall))
        }

        private fun wrapped(d: Double) = if (boundary is Periodic) d - EDGE * Math.rint(d / EDGE) else d

        override fun toString() = "seed $seed: $giants giants of mass $mass, ${boundary.javaClass.simpleName}, dt $dt"
    }

    @Test
    fun `giants that keep their lines, and others that do not, give the serial engine's bits after every step`() {
        var kept = 0L
        var collisions = 0L
        var bounces = 0L
        var giants = 0L
        for (seed in 1..DRAWS) {
            val draw = Draw(seed)
            val pool = FixedPool(1 + (seed % 2).toInt() * (seed % 7).toInt() / 3)
            val engine = HorizonEngine(pool, 0, TUNINGS[(seed % TUNINGS.size).toInt()])
            val serial = draw.simulation(SerialEngine())
            val horizon = draw.simulation(engine)
            for (step in 1..STEPS) {
                serial.advance()
                horizon.advance()
                assertSameStep(serial, horizon, "$draw, step $step")
            }
            engine.close()
            kept += engine.kept
            giants += engine.giants
            collisions += serial.collisions!!.counters.collisions
            bounces += serial.collisions!!.counters.wallCollisions
        }
        println("$collisions collisions, $kept in which giants kept their lines; $giants giants; $bounces at walls")
        assertTrue(giants > 2 * DRAWS) { "$giants giants" }
        assertTrue(kept > 100 * DRAWS && collisions > 2 * kept) { "$kept of $collisions collisions" }
        assertTrue(bounces > DRAWS) { "$bounces at walls" }
    }

    @Test
    fun `a sphere whose contact a giant leaves for a later step is found in that step`() {
        val random = SeededRandom(5)
        val cos = cos(Math.toRadians(20.0))
        val sin = sin(Math.toRadians(20.0))
        val mass = 1e4

        /** The mass that gives the giant a velocity of [u] along x when it hits with [v]; restitution is 1/2. */
        fun massFor(u: Double, v: Double) = (u / cos * mass / (1.5 * v)).let { it / (1 - it / mass) }
        repeat(40) {
            // One comes slowly from the left; when its contact is near, two others make the giant flee before it.
            val gap = 0.0045 + random.nextDouble(-1e-4, 1e-4)
            val slowest = random.nextDouble(1e-5, 4e-4)
            val early = 11.0 + 3.2 * 0.01
            val late = 11.0 + 3.4 * 0.355
            val spheres = listOf(
                Sphere(r = 10.0, m = mass),
                Sphere(-(11 + gap), vx = 0.01),
                Sphere(-early * cos, early * sin, vx = 3.2 * cos, vy = -3.2 * sin, m = massFor(0.00044, 3.2)),
                Sphere(-late * cos, -late * sin, vx = 3.4 * cos, vy = 3.4 * sin, m = massFor(0.00956 - slowest, 3.4)),
            ) + List(1000) { Sphere(30.0 + 6 * (it % 10), 6.0 * (it / 10 % 10) - 27, 6.0 * (it / 100) - 27) }
            fun simulation(engine: CollisionEngine) = simulationOf(
                populationOf(*spheres.toTypedArray()),
                Open,
                1.0,
                ConstantRestitution(0.5),
                engine = engine,
            )
            val engine = HorizonEngine(FixedPool(1), 0, HorizonTuning(32, deviation = 0.5))
            val serial = simulation(SerialEngine())
            val horizon = simulation(engine)
            for (step in 1..20) {
                serial.advance()
                horizon.advance()
                assertSameStep(serial, horizon, "gap $gap, $slowest, step $step")
            }
            assertTrue(engine.kept >= 2) { "${engine.kept} kept" }
            engine.close()
        }
    }

    @Test
    fun `spheres of one size are no giants, also where floats have no such radius`() {
        val random = SeededRandom(1)
        val spheres = Array(512) {
            fun at(c: Int) = 2.0 * (c % 8) - 7.0
            val fast = if (it % 10 == 0) 30.0 else 1.0
            Sphere(at(it), at(it / 8), at(it / 64), vx = fast * random.nextGaussian(), r = 0.4)
        }
        val engine = HorizonEngine(FixedPool(1), 0, HorizonTuning(2))
        simulationOf(populationOf(*spheres), Periodic(Box.centred(EDGE, EDGE, EDGE)), 0.02, engine = engine).use {
            repeat(8) { _ -> it.advance() }
            assertEquals(8L, engine.epochSteps)
            assertEquals(0L, engine.giants)
        }
    }

    @Test
    fun `a patch of ring that is long as compared with its particles has epochs`() {
        val random = SeededRandom(1)
        val spheres = Array(16_384) {
            fun along(c: Int, n: Int, length: Double) = length * ((c + random.nextDouble(0.3, 0.7)) / n - 0.5)
            Sphere(
                along(it % 4, 4, 10.0),
                along(it / 4, 4096, 12_600.0),
                random.nextDouble(-0.3, 0.3),
                vx = 0.02 * random.nextGaussian(),
                r = 0.15,
            )
        }
        val box = Periodic(Box.centred(10.0, 12_600.0, 1.0), periodicX = false, periodicZ = false)
        val serial = simulationOf(populationOf(*spheres), box, 10.0)
        val engine = HorizonEngine(FixedPool(1), 0)
        val horizon = simulationOf(populationOf(*spheres), box, 10.0, engine = engine)
        for (step in 1..20) {
            serial.advance()
            horizon.advance()
            assertSameStep(serial, horizon, "step $step")
        }
        val collisions = serial.collisions!!.counters.collisions
        assertTrue(collisions > 500) { "$collisions collisions" }
        assertEquals(20L, engine.epochSteps)
        assertTrue(engine.epochs < 10) { "${engine.epochs} epochs" }
        engine.close()
    }

    private companion object {
        const val STEPS = 40
        const val EDGE = 16.0
        const val SIDE = 9
        const val RADIUS = 1.8
        const val SMALL = 0.25
        val TUNINGS = listOf(
            HorizonTuning(1),
            HorizonTuning(4, deviation = 0.3),
            HorizonTuning(1).inWindows(3),
            HorizonTuning(8, deviation = 0.0),
            null,
        )
        val DRAWS = Draws.share(usual = 60, long = 1000)

        fun distance(dx: Double, dy: Double, dz: Double) = sqrt(dx * dx + dy * dy + dz * dz)
    }
}
