package daphnis.core.engine

import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.cluster.bricks.BrickDivision
import daphnis.core.cluster.bricks.BricksTogether
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.parallel.FixedPool
import daphnis.core.permuted
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.simulationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

/** A step is refused for what its spheres do, not for what an engine remembers or guesses. */
@Timeout(120)
class RefusalsAgreeTest {
    private val box = Periodic(Box.centred(1.0, 5000.0, 50.0))

    private fun engines() = listOf(
        SerialEngine(),
        HorizonEngine(FixedPool(2), fewest = 0),
        BricksTogether(FixedPool(2), BrickDivision(2, 2, 2)),
        ThreadPoolEngine(2),
        HorizonEngine(FixedPool(1), fewest = 0, tuning = HorizonTuning(3)),
    )

    private fun end(p: Population, boundary: BoundaryConditions, engine: CollisionEngine, dt: Double = 1.0): String {
        val before = stateDigest(p)
        return try {
            simulationOf(p, boundary, dt, engine = engine).advance()
            stateDigest(p)
        } catch (e: IllegalArgumentException) {
            assertEquals(before, stateDigest(p))
            e.message!!
        }
    }

    @Test
    fun `spheres may go eight boxes less their radius, whatever engines remember of earlier steps`() {
        // A bound of 16 boxes for the pair: 8 - 0.1 for one sphere.
        for ((speed, isRefused) in listOf(7.6 to false, 7.89 to false, 7.91 to true, -7.91 to true)) {
            val start =
                populationOf(
                    Sphere(vx = speed, r = 0.1),
                    Sphere(y = 1.0, vy = 1.0, r = 0.1),
                    Sphere(x = 0.4, y = 3.0, r = 0.1),
                )
            val ends = engines().flatMap { engine ->
                engine.use {
                    val fresh = end(start.copy(), box, engine)
                    // A heavy sphere that hits a light one, which outruns the bound: headroom grows and is kept.
                    val before =
                        simulationOf(
                            populationOf(Sphere(vx = 1.0, m = 1000.0, r = 0.5), Sphere(x = 2.0, m = 0.001, r = 0.5)),
                            Open,
                            20.0,
                            engine = engine,
                        )
                    repeat(3) {
                        before.advance()
                        before.population.vx.fill(0.0)
                        before.population.x[before.population.indexOf(0)] = 0.0
                        before.population.x[before.population.indexOf(1)] = 2.0
                        before.population.vx[before.population.indexOf(0)] = 1.0
                    }
                    // In its epochs, horizon needs no bound.
                    assertTrue(before.collisions!!.counters.redoneSteps > 0 || engine is HorizonEngine)
                    listOf(fresh, end(start.permuted(7), box, engine))
                }
            }
            assertEquals(1, ends.toSet().size) { "speed $speed: $ends" }
            assertEquals(isRefused, "16 boxes away along x" in ends[0]) { "speed $speed: ${ends[0]}" }
        }
    }

    @Test
    fun `a collision that sends a sphere too far is what refuses a step, and nothing less`() {
        // A light sphere that a heavy one pushes has twice its speed: if nothing more happens, it goes 7.7 or 8.1
        // boxes.
        for ((speed, isRefused) in listOf(3.9 to false, 4.1 to true)) {
            val start = populationOf(
                Sphere(x = -0.3, vx = speed, r = 0.1, m = 1e9),
                Sphere(r = 0.1),
                Sphere(x = 0.3, y = 20.0, vx = 1.0, r = 0.1),
                Sphere(x = -0.3, y = 20.0, vx = 2.0, r = 0.1),
            )
            val ends = engines().flatMap { engine ->
                engine.use { listOf(end(start.copy(), box, engine), end(start.permuted(3), box, engine)) }
            }
            assertEquals(1, ends.toSet().size) { "speed $speed: $ends" }
            assertEquals(isRefused, "16 boxes away along x" in ends[0]) { "speed $speed: ${ends[0]}" }
        }
    }

    @Test
    fun `a path that would go too far, but is left before, refuses nothing`() {
        // 0 would push 1, light, at 0.09, so that it went 11 boxes. But 3 pushes 2 at 0.02, and 2 pushes 0 out of the
        // way at 0.05.
        val start = populationOf(
            Sphere(x = -0.3, vx = 6.0, r = 0.1),
            Sphere(x = 0.45, r = 0.1, m = 0.01),
            Sphere(y = -2.0, r = 0.1, m = 1e6),
            Sphere(y = -2.8, vy = 30.0, r = 0.1, m = 1e9),
        )
        val ends = engines().map { engine -> engine.use { end(start.copy(), box, it) } }
        assertEquals(1, ends.toSet().size) { "$ends" }
        assertTrue("boxes" !in ends[0]) { ends[0] }
    }

    @Test
    fun `images that slide over many boxes within a step are told from one another or the step is refused`() {
        val start = populationOf(Sphere(vy = 5.0, r = 0.1), Sphere(x = 0.3, r = 0.1))
        for ((shear, isRefused) in listOf(1.0 to false, 500.0 to true)) {
            val boundary = LeesEdwards(Box.centred(1.0, 1.0, 1.0), shear)
            val ends = engines().map { engine -> engine.use { end(start.copy(), boundary, it) } }
            assertEquals(1, ends.toSet().size) { "$ends" }
            assertEquals(isRefused, "boxes away along y" in ends[0]) { "shear $shear: ${ends[0]}" }
        }
    }

    /** Two that meet head-on and a third that is hit in turn, scaled. */
    private fun scaled(length: Double, speed: Double) = populationOf(
        Sphere(x = -3.0 * length, vx = speed, r = length),
        Sphere(x = 0.3 * length, y = 0.5 * length, vx = -speed, r = length),
        Sphere(x = -4.0 * length, y = 3.0 * length, r = length),
        Sphere(x = 9.0 * length, r = length, vx = -3 * speed),
    )

    @Test
    fun `scales from 1e-30 to 1e30 give the same bits but for the power of two`() {
        val expected = scaled(1.0, 1.0).also { end(it, Open, SerialEngine(), 10.0) }
        for (length in listOf(-100, 100)) {
            for (speed in listOf(-100, 100)) {
                val p = scaled(Math.scalb(1.0, length), Math.scalb(1.0, speed))
                end(p, Open, SerialEngine(), Math.scalb(10.0, length - speed))
                for (k in 0 until p.size) {
                    assertEquals(expected.x[expected.indexOf(p.id[k])], Math.scalb(p.x[k], -length)) {
                        "2^$length, 2^$speed"
                    }
                    assertEquals(expected.vy[expected.indexOf(p.id[k])], Math.scalb(p.vy[k], -speed)) {
                        "2^$length, 2^$speed"
                    }
                }
            }
        }
    }

    @Test
    fun `a number that is not finite is refused, with its name, wherever it stands`() {
        val columns = mapOf<String, (Population) -> DoubleArray>(
            "x" to { it.x },
            "y" to { it.y },
            "z" to { it.z },
            "vx" to { it.vx },
            "vy" to { it.vy },
            "vz" to { it.vz },
            "radius" to { it.radius },
            "mass" to { it.mass },
        )
        for ((name, column) in columns) {
            for (bad in listOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)) {
                for (boundary in listOf(Open, box)) {
                    val ends = engines().map { engine ->
                        val start = scaled(1.0, 1.0)
                        column(start)[2] = bad
                        engine.use { end(start, boundary, it) }
                    }
                    assertEquals(setOf("$name of particle 2 is $bad; it must be finite"), ends.toSet())
                }
            }
        }
    }

    @Test
    fun `a sphere outside a periodic box is refused, not searched for at the wrong images, and its faces are inside`() {
        for (boundary in listOf(Periodic(Box.centred(4.0, 6.0, 8.0)), LeesEdwards(Box.centred(4.0, 6.0, 8.0), 0.1))) {
            for ((place, isRefused) in listOf(
                -3.0 to false,
                3.0 to false,
                3.001 to true,
                -9.0 to true,
                1e300 to true,
            )) {
                val ends = engines().map { engine ->
                    val start = populationOf(Sphere(y = place, vx = 1.0, r = 0.2), Sphere(x = 1.0, r = 0.2))
                    engine.use { end(start, boundary, it, 0.1) }
                }
                assertEquals(1, ends.toSet().size) { "$place: $ends" }
                assertEquals(isRefused, "a sphere is at y = $place, outside the box" in ends[0]) {
                    "$place: ${ends[0]}"
                }
            }
        }
    }

    @Test
    fun `scales whose squares underflow or overflow are refused, with the number and the reason`() {
        for ((length, speed, dt) in listOf(
            Triple(1e-100, 1e-100, 1.0),
            Triple(1.0, 1e150, 1e-149),
            Triple(1e100, 1.0, 1e101),
            Triple(1e-60, 1e-70, 1e12),
        )) {
            for (engine in engines()) {
                val message = end(scaled(length, speed), Open, engine, dt)
                assertTrue("choose other units" in message) { "$length, $speed, ${engine.name}: $message" }
                engine.close()
            }
        }
        assertThrows(IllegalArgumentException::class.java) { simulationOf(scaled(1e-100, 1e-100), Open, 1.0).advance() }
    }
}
