package daphnis.core.physics

import daphnis.core.CarriedState
import daphnis.core.Engines
import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Pistons
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.ConstantRoughness
import daphnis.core.wall.Piston
import daphnis.core.wall.WallFace
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sqrt

/** Gases of spheres of mass 1 and temperature 1 under pistons across x. */
class PistonTest {
    private class Gas(
        seed: Long,
        count: Int,
        val lengths: List<Double>,
        val pistons: Map<Int, Piston>,
        dt: Double,
        engine: CollisionEngine = SerialEngine(),
        restitution: Double = 1.0,
        outputs: List<Output> = emptyList(),
        radius: Double = RADIUS,
    ) : AutoCloseable {
        val population: Population
        val simulation: Simulation

        init {
            val random = SeededRandom(seed)
            val box = Box(0.0, 0.0, 0.0, lengths[0], lengths[1], lengths[2])
            val walled = booleanArrayOf(true, false, false)
            val radii = DoubleArray(count) { radius }
            val places = RandomPlacement().place(radii, box, walled, random)

            // At rest as a whole, and with the temperature 1.
            fun gauss() = DoubleArray(count) { random.nextGaussian() }.let { v ->
                val mean = v.average()
                val factor = sqrt(v.sumOf { (it - mean) * (it - mean) } / count)
                DoubleArray(count) { (v[it] - mean) / factor }
            }
            population =
                Population(places.x, places.y, places.z, gauss(), gauss(), gauss(), radii, DoubleArray(count) { 1.0 })
            val faces = List(6) { face -> pistons[face]?.let { WallFace(motion = it) } }
            val forcing =
                CollisionForcing(ConstantRestitution(restitution), engine = engine, recordCollisions = true)
            simulation = Simulation(
                population,
                Walls(box, 1.0, walled, faces = faces),
                forcing,
                FixedTimeStep(dt),
                outputs = outputs,
            )
        }

        fun kinetic() = (0 until population.size).sumOf {
            0.5 * population.run { vx[it] * vx[it] + vy[it] * vy[it] + vz[it] * vz[it] }
        }

        fun energy() = kinetic() + pistons.values.sumOf { it.energy }

        fun momentum() = population.vx.sum() + pistons.values.sumOf { it.mass * it.speed }

        override fun close() = simulation.close()
    }

    private fun between(seed: Long, dt: Double, mass: Double = 50.0) =
        Gas(seed, 60, listOf(8.0, 6.0, 6.0), mapOf(0 to Piston(mass, 7.0), 1 to Piston(mass, -7.0)), dt)

    @Test
    fun `momentum of a gas between two pistons stays to round-off, and energy nearly`() {
        val drifts = listOf(0.1, 0.025).map { dt ->
            (1L..if (isFull) 64L else 4L).map { seed ->
                between(seed, dt).use { gas ->
                    val before = gas.energy()
                    while (gas.simulation.time < 60) gas.simulation.advance()
                    assertEquals(0.0, gas.momentum(), 1e-11)
                    assertTrue(gas.pistons.values.all { it.speed != 0.0 })
                    (gas.energy() - before) / before
                }
            }
        }
        if (isFull) {
            for (some in drifts) {
                val mean = some.average()
                val spread = sqrt(some.sumOf { (it - mean).pow(2) } / (some.size - 1))
                println("relative change of the energy $mean ± ${spread / sqrt(some.size.toDouble())}, spread $spread")
            }
            return
        }
        for (drift in drifts[0]) assertTrue(abs(drift) < 0.03) { "$drifts" }
        for (drift in drifts[1]) assertTrue(abs(drift) < 0.01) { "$drifts" }
    }

    @Test
    fun `an isobaric gas has the volume and the fluctuations of its ensemble`() {
        val force = 6.0
        val count = 60
        val samples = if (isFull) 5000 else 500
        var start = 0.0
        val blocks = (1L..if (isFull) 16L else 3L).map { seed ->
            val piston = Piston(100.0, -force)
            Gas(seed, count, listOf(10.0, 6.0, 6.0), mapOf(1 to piston), 0.1).use { gas ->
                // Two radii at the walls, and four volumes of a sphere for each.
                val excluded = 2 * RADIUS + count * 16.0 / 3 * Math.PI * RADIUS.pow(3) / 36
                start = gas.energy() + force * (10.0 - excluded)
                while (gas.simulation.time < 100) gas.simulation.advance()
                var sum = 0.0
                var squares = 0.0
                var enthalpy = 0.0
                repeat(samples) {
                    repeat(10) { gas.simulation.advance() }
                    val length = 10.0 + piston.position - excluded
                    val h = gas.kinetic() + 0.5 * piston.mass * piston.speed * piston.speed + force * length
                    sum += force * length / h / samples
                    squares += (force * length / h).pow(2) / samples
                    enthalpy += h / samples
                }
                doubleArrayOf(sum, squares - sum * sum, enthalpy)
            }
        }
        // Conserved enthalpy H: F L/H is a beta variable with N + 1 and half the number of momenta. Those along y and z
        // of the whole gas are 0.
        val a = count + 1.0
        val b = (3 * count - 2 + 1) / 2.0
        val mean = blocks.map { it[0] }.average()
        val variance = blocks.map { it[1] }.average()
        val expected = a * b / (a + b).pow(2) / (a + b + 1)
        if (isFull) {
            fun error(k: Int, m: Double) = sqrt(blocks.sumOf { (it[k] - m).pow(2) } / blocks.size / (blocks.size - 1))
            println(
                "F L/H $mean ± ${error(
                    0,
                    mean,
                )} of ${a / (a + b)}, variance $variance ± ${error(1, variance)} of $expected",
            )
            println("enthalpies ${blocks.map { it[2] }}")
        }
        assertEquals(1.0, mean / (a / (a + b)), if (isFull) 0.006 else 0.04)
        assertEquals(1.0, variance / expected, if (isFull) 0.15 else 0.6)
        for (block in blocks) assertEquals(start, block[2], 0.03 * start)
    }

    @Test
    fun `a heavy piston swings on a gas with the period of its adiabat`() {
        val count = if (isFull) 2000 else 300
        val mass = 50.0 * count
        val piston = Piston(mass, -0.08 * count)
        val turns = ArrayList<Double>()
        val lengths = listOf(10.0, 10.0, count / 50.0)
        Gas(1, count, lengths, mapOf(1 to piston), 0.2, radius = WIDE).use { gas ->
            var before = piston.speed
            while (turns.size < 4) {
                gas.simulation.advance()
                // Near a turning point noise makes the speed cross zero a few times: the first counts.
                val isTurned = (piston.speed > 0) != (before > 0)
                if (isTurned && gas.simulation.time > 60 + (turns.lastOrNull() ?: 0.0)) turns += gas.simulation.time
                before = piston.speed
            }
        }
        val period = turns.last() - turns[1]
        val expected = period(count, mass + count / 3.0, 0.08 * count, lengths[1] * lengths[2])
        if (isFull) println("period $period of $expected")
        assertEquals(1.0, period / expected, if (isFull) 0.02 else 0.06) { "$period for $expected" }
    }

    /**
     * Of M L″ = p A − F from rest at L = 10 along the adiabat d ln T = −(2/3) Z d ln V of Carnahan & Starling, V being
     * the volume in which centres can be. A third of the gas moves with the piston.
     */
    private fun period(count: Int, mass: Double, force: Double, area: Double): Double {
        var x = 10.0 - 2 * WIDE
        var temperature = 1.0
        var v = 0.0
        var t = 0.0
        val dt = 0.01
        do {
            val filling = count * 4.0 / 3 * Math.PI * WIDE.pow(3) / (area * x)
            val z = (1 + filling + filling.pow(2) - filling.pow(3)) / (1 - filling).pow(3)
            v += dt * (count * z * temperature / x - force) / mass
            temperature *= 1 - 2.0 / 3 * z * dt * v / x
            x += dt * v
            t += dt
        } while (v > 0)
        return 2 * t
    }

    @Test
    fun `engines and threads give the same bits of spheres and pistons`() {
        fun bits(engine: CollisionEngine, restitution: Double): List<Any> {
            val pistons = mapOf(0 to Piston(60.0, 9.0, -0.5, 0.1), 1 to Piston(45.0, -8.0))
            return Gas(3, 300, listOf(9.0, 9.0, 9.0), pistons, 0.07, engine, restitution).use { gas ->
                repeat(120) { gas.simulation.advance() }
                listOf(stateDigest(gas.population)) + pistons.values.flatMap { listOf(it.position, it.speed) }
            }
        }
        for (restitution in listOf(1.0, 0.7)) {
            val expected = bits(SerialEngine(), restitution)
            assertEquals(expected, bits(Engines.horizon(1), restitution))
            assertEquals(expected, bits(Engines.horizon(3), restitution))
            // One that would lay out epochs of five steps wherever it may.
            assertEquals(expected, bits(HorizonEngine(FixedPool(2), 0, HorizonTuning(5)), restitution))
        }
    }

    @Test
    fun `a step that fails leaves the piston where it was`() {
        var fails = false
        val failing = object : Output {
            override fun write(simulation: Simulation) {
                if (fails) error("no more")
            }
        }
        val piston = Piston(50.0, -7.0)
        Gas(5, 60, listOf(8.0, 6.0, 6.0), mapOf(1 to piston), 0.1, outputs = listOf(failing)).use { gas ->
            repeat(20) { gas.simulation.advance() }
            val before = piston.position to piston.speed
            fails = true
            assertThrows(IllegalStateException::class.java) { gas.simulation.advance() }
            assertEquals(before, piston.position to piston.speed)
            fails = false
            gas.simulation.advance()
            assertNotEquals(before, piston.position to piston.speed)
        }
    }

    @Test
    fun `a piston that comes too near is told, and one that is not recorded is refused`() {
        val piston = Piston(50.0, 25.0)
        val walls = Walls(
            Box.centred(5.0, 5.0, 5.0),
            faces = listOf(WallFace(motion = piston)) + List(5) { null },
        )
        val one = DoubleArray(1) { 1.0 }
        val sphere = Population(one, one, one, one, one, one, one, one)
        val pistons = Pistons.of(walls, CollisionRecord(), sphere)!!
        // From rest with the acceleration 1/2: after 3 units of time the walls are 2.75 apart, and the sphere 2 wide.
        pistons.move(3.0, 3.0)
        assertEquals(2.25, piston.position)
        val carried = CarriedState(walls, emptyList()).also { it.begin() }
        val near = assertThrows(IllegalStateException::class.java) { pistons.move(1.0, 4.0) }.message.orEmpty()
        assertTrue("the walls across x are 1.0 apart at time 4.0" in near && "2.0 wide" in near) { near }
        carried.takeBack()
        assertEquals(listOf(2.25, 1.5), listOf(piston.position, piston.speed))
        val rough = List(6) { if (it == 0) ConstantRoughness(0.5) else null }
        val faces = List(6) { if (it == 0) WallFace(motion = piston) else null }
        assertThrows(IllegalArgumentException::class.java) { Walls(walls.box, roughness = rough, faces = faces) }
        assertThrows(IllegalArgumentException::class.java) { WallFace(motion = piston, temperature = 1.0) }
        val told = assertThrows(IllegalArgumentException::class.java) {
            Simulation(sphere, walls, CollisionForcing(ConstantRestitution(1.0)), FixedTimeStep(0.1))
        }.message.orEmpty()
        assertTrue("recordCollisions" in told) { told }
    }

    @Test
    fun `one impact is that of two bodies`() {
        for (restitution in listOf(1.0, 0.4)) {
            val piston = Piston(9.0, 0.0, 0.0, -0.5)
            val box = Box(0.0, 0.0, 0.0, 10.0, 4.0, 4.0)
            val p = Population(
                doubleArrayOf(5.0),
                doubleArrayOf(2.0),
                doubleArrayOf(2.0),
                doubleArrayOf(2.0),
                DoubleArray(1),
                DoubleArray(1),
                doubleArrayOf(0.5),
                doubleArrayOf(1.0),
            )
            val faces = List(6) { if (it == 1) WallFace(restitution, piston) else null }
            val walls = Walls(box, 1.0, booleanArrayOf(true, false, false), faces = faces)
            val forcing = CollisionForcing(ConstantRestitution(1.0), recordCollisions = true)
            Simulation(p, walls, forcing, FixedTimeStep(2.5)).use { it.advance() }
            // In the frame of the centre of mass, at speed −0.25, relative velocities turn around.
            val u = 2.0 + 0.5
            assertEquals(-0.25 - restitution * u * 0.9, p.vx[0], 1e-14)
            assertEquals(-0.25 + restitution * u * 0.1, piston.speed, 1e-14)
            assertEquals(-1.25, piston.position, 1e-14)
        }
    }

    private companion object {
        const val RADIUS = 0.1

        /** So wide that a gas of them is near equilibrium all the time. */
        const val WIDE = 0.2
        val isFull = System.getProperty("daphnis.physics") == "full"
    }
}
