package daphnis.core.engine

import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.cluster.bricks.BrickDivision
import daphnis.core.cluster.bricks.BricksTogether
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.parallel.FixedPool
import daphnis.core.permuted
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

/**
 * Whether and why a step fails belongs to the trajectory: the same from every engine, for every number of threads and
 * every order of the arrays.
 */
@Timeout(120)
class EndsAgreeTest {
    private val elastic = ConstantRestitution(1.0)

    /**
     * What one step of [start] comes to: a digest and counts, or what was thrown, in which case the population has to
     * be as before.
     */
    private fun end(
        start: Population,
        boundary: BoundaryConditions,
        dt: Double,
        restitution: Restitution,
        engine: CollisionEngine,
    ): String {
        val p = start.copy()
        val before = stateDigest(p)
        simulationOf(p, boundary, dt, restitution, engine = engine).use { simulation ->
            try {
                simulation.advance()
            } catch (e: RuntimeException) {
                assertEquals(before, stateDigest(p)) { engine.name }
                return "${e.javaClass.simpleName}: ${e.message}"
            }
            val counters = simulation.collisions!!.counters
            replays = counters.causalityReplays
            return "${stateDigest(p)} ${counters.collisions} ${counters.wallCollisions}"
        }
    }

    private var replays = 0L

    private fun islands(threads: Int) = IslandsEngine(FixedPool(threads), fewest = 0)

    private fun horizon(steps: Int) = HorizonEngine(FixedPool(1), fewest = 0, tuning = HorizonTuning(steps))

    /** The end that all engines agree on. */
    private fun common(
        start: Population,
        boundary: BoundaryConditions,
        dt: Double,
        restitution: Restitution = elastic,
    ): String {
        val expected = end(start, boundary, dt, restitution, SerialEngine())
        for (seed in 1L..3L) {
            assertEquals(
                expected,
                end(start.permuted(seed), boundary, dt, restitution, SerialEngine()),
            ) {
                "serial, order $seed"
            }
        }
        for (threads in 1..4) {
            assertEquals(expected, end(start, boundary, dt, restitution, islands(threads))) { "islands on $threads" }
            assertEquals(expected, end(start.permuted(4), boundary, dt, restitution, ThreadPoolEngine(threads))) {
                "thread-pool on $threads"
            }
            assertEquals(expected, end(start.permuted(5), boundary, dt, restitution, horizon(threads))) {
                "horizon, epochs of $threads steps"
            }
        }
        return expected
    }

    private fun line(count: Int, y: Double = 0.0) = Array(count) {
        Sphere(
            x = 2.2 * it,
            y = y,
            vx =
            -1.0 * (it - (count - 1) / 2.0),
        )
    }

    @Test
    fun `an island that collapses on a false path is put before the serial engine`() {
        // The line would collapse at 0.2; a heavy sphere that another has deflected at 0.02 scatters it at 0.08.
        val start = populationOf(
            *line(6),
            Sphere(x = 5.5 - 20, y = -40 * Math.sqrt(0.75), r = 10.0, m = 1e3),
            Sphere(x = 5.5 - 50, y = -60 * Math.sqrt(0.75), vx = 1000.0, r = 10.0, m = 1e6),
        )
        val restitution = Restitution { if (it > 20) 1.0 else 0.01 }
        val end = common(start, Open, 0.5, restitution)
        assertTrue("Exception" !in end) { end }
        for (threads in 1..3) {
            end(start, Open, 0.5, restitution, islands(threads))
            assertEquals(1L, replays) { "no island collapsed: the case does not test what it should" }
        }
    }

    @Tag("thorough")
    @Test
    fun `very many honest collisions before one that was taken early are no collapse`() {
        val light = common(
            populationOf(
                Sphere(x = -2.5, m = 1e12),
                Sphere(x = 2.5, m = 1e12),
                Sphere(vx = 1.2e5),
                Sphere(x = 1e7, vx = 0.5),
                Sphere(x = 1e7 + 2.9, vx = -0.5),
            ),
            Open,
            1.0,
        )
        assertTrue(light.endsWith(" 118869 0")) { light }
        val walls = Walls(Box(-2.0, -3e6, -2.0, 2.0, 3e6, 2.0))
        val wall =
            common(populationOf(Sphere(vx = 3e5), Sphere(y = 2e6, vx = 1.5), Sphere(y = -2e6, vx = 1.0)), walls, 1.0)
        assertTrue(wall.endsWith(" 0 150002")) { wall }
    }

    @Tag("thorough")
    @Test
    fun `sixty heaps that come to rest at one moment are no collapse`() {
        val end =
            common(
                populationOf(
                    *Array(60) {
                        line(4, y = 8.0 * it)
                    }.flatten().toTypedArray(),
                ),
                Open,
                4.0,
                ConstantRestitution(0.0),
            )
        assertTrue(end.endsWith(" 173160 0")) { end }
    }

    @Test
    fun `a collapse is the same in every engine, of two at one moment too`() {
        for (start in listOf(populationOf(*line(10)), populationOf(*line(10), *line(10, y = 50.0)))) {
            val end = common(start, Open, 4.0, ConstantRestitution(0.3))
            assertTrue(end.startsWith("CollapseException")) { end }
        }
    }

    @Tag("thorough")
    @Test
    fun `spheres that touch in a full box collapse in bounded time`() {
        val edge = 8
        fun at(k: Int) = 0.5 + k
        val jam = Array(edge * edge * edge) { k ->
            val speed = Math.sin(7.0 * k)
            Sphere(at(k % edge), at(k / edge % edge), at(k / edge / edge), speed, Math.cos(3.0 * k), -speed, r = 0.5)
        }
        val box = Box(0.0, 0.0, 0.0, 1.0 * edge, 1.0 * edge, 1.0 * edge)
        for (boundary in listOf(Walls(box), Periodic(box))) {
            for (e in listOf(0.0, 1.0)) {
                val end = common(populationOf(*jam), boundary, 0.1, ConstantRestitution(e))
                assertTrue(end.startsWith("CollapseException")) { end }
            }
        }
    }

    @Test
    fun `an island that goes on and on is given up for the serial engine`() {
        val start = populationOf(Sphere(vx = 1.2e6))
        val walls = Walls(Box.centred(4.0, 4.0, 4.0))
        assertEquals(end(start, walls, 1.0, elastic, SerialEngine()), end(start, walls, 1.0, elastic, islands(2)))
        assertEquals(1L, replays)
        // One that does not is not.
        val few = populationOf(Sphere(vx = 1.2e3))
        assertEquals(end(few, walls, 1.0, elastic, SerialEngine()), end(few, walls, 1.0, elastic, islands(2)))
        assertEquals(0L, replays)
    }

    @Test
    fun `a law that throws on a false path only does no harm, one that throws on the true one ends the step`() {
        val pairs = populationOf(
            Sphere(x = 0.0, vx = 10.0, r = 0.5),
            Sphere(x = 2.0, r = 0.5, m = 0.1),
            Sphere(x = 6.0, y = 2.5, r = 0.5),
            Sphere(x = 6.0, y = 4.5, vy = -10.0, r = 0.5),
            Sphere(x = 6.0, y = -6.0, vy = -1.0, r = 0.5),
        )
        val speeds = HashSet<Double>()
        val listening = Restitution { speeds.add(it).let { 1.0 } }
        val expected = end(pairs, Open, 1.0, listening, SerialEngine())
        // Sphere 2 flies on to 4 on the path that it has before 1 hits it.
        val picky = Restitution { if (it in speeds) 1.0 else throw ArithmeticException("at speed $it") }
        assertEquals(expected, end(pairs, Open, 1.0, picky, islands(1)))
        assertEquals(1L, replays) { "no island was wrong: the case does not test what it should" }
        val broken = Restitution { throw ArithmeticException("on purpose") }
        for (engine in listOf(
            islands(2),
            BricksTogether(FixedPool(2), BrickDivision(2, 1, 1)),
            ThreadPoolEngine(2),
            horizon(2),
        )) {
            assertEquals("ArithmeticException: on purpose", end(pairs, Open, 1.0, broken, engine))
        }
    }
}
