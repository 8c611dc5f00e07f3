package daphnis.core.cluster

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.at
import daphnis.core.cluster.bricks.BrickAhead
import daphnis.core.cluster.bricks.HaloMargins
import daphnis.core.cluster.bricks.LongBox
import daphnis.core.compression.GrowingSpheres
import daphnis.core.engine.Case
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.Draw
import daphnis.core.engine.Draws
import daphnis.core.engine.OddDraw
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.engine.failure
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.Random

/** Nodes on threads of this process, with mail as bytes, against the serial engine. */
@Timeout(600)
class NodeEngineTest {
    private val draws = Draws.of(usual = 150, long = 3000)

    private fun case(seed: Long): Case = if (seed % 3 == 0L) OddDraw(seed) else Draw(seed)

    private fun nodes(case: Case): NodesTogether {
        val random = case.random
        val threads = IntArray(1 + random.nextInt(4)) { 1 + random.nextInt(3) }
        val width = WIDTHS[random.nextInt(WIDTHS.size)]
        val tuning = HorizonTuning(1 + random.nextInt(20), deviation = random.nextInt(3) * 0.1)
        val ahead = if (random.nextInt(3) == 0) BrickAhead.Choice.QUICKEST else BrickAhead.Choice(0, tuning)
        return NodesTogether(Random(random.nextInt(1 shl 30).toLong()), threads, ahead) { HaloMargins(width, 0.0) }
    }

    @Test
    fun `nodes give the digest, counts, collisions and exceptions of the serial engine, whoever holds the spheres`() {
        var redone = 0L
        var replays = 0L
        var failures = 0
        for (seed in Draws.first..<Draws.first + draws) {
            val case = case(seed)
            val serial = case.simulation(SerialEngine())
            val engine = nodes(case)
            case.simulation(engine).use { nodes ->
                for (step in 1..5) {
                    val expected = failure(serial)
                    val story = "$case, step $step, nodes with ${engine.threads} bricks"
                    assertEquals(expected, failure(nodes)) { story }
                    assertSameStep(serial, nodes, story)
                    if (expected != null) failures++
                    if (expected != null) break
                }
                replays += nodes.collisions!!.counters.causalityReplays
            }
            redone += engine.redone
        }
        println(
            "$draws draws, $redone redone, $replays with all spheres everywhere, $failures that end by an exception",
        )
        if (draws < 100) return
        assertTrue(redone > draws / 4) { "only $redone steps redone: halos are never too narrow" }
        assertTrue(failures > 0) { "no case fails: the draws do not test what they should" }
        assertTrue(replays < draws / 4) { "$replays of $draws with all spheres everywhere" }
    }

    @Tag("thorough")
    @Test
    fun `nodes that do not compare paths go wrong, so the draws test the comparison`() {
        var wrong = 0
        for (seed in 1..20L) {
            val case = LongBox(seed)
            val serial = simulationOf(case.population.copy(), case.boundary, LongBox.DT)
            val engine = NodesTogether(Random(seed), intArrayOf(2, 1, 1)) { HaloMargins(0.0, 0.0) }
            engine.isTrusting = true
            simulationOf(case.population.copy(), case.boundary, LongBox.DT, engine = engine).use {
                serial.advance()
                it.advance()
                if (stateDigest(serial.population) != stateDigest(it.population)) wrong++
            }
        }
        assertTrue(wrong > 5) { "only $wrong cases are wrong without a comparison" }
    }

    @Test
    fun `a box that narrows and widens under its cuts changes no bit`() {
        val boundary = HillSheet(Box.centred(12.0, 20.0, 6.0), 0.2, perturbation = 0.6)
        val start = randomSpheres(300, boundary.at(0.0), 4, 0.5) { 0.3 }
        fun sheet(engine: CollisionEngine) = Simulation(
            start.copy(),
            boundary,
            CollisionForcing(ConstantRestitution(0.7), engine = engine, recordCollisions = true),
            FixedTimeStep(0.4),
            listOf(HillFrame(0.2)),
        )
        val serial = sheet(SerialEngine())
        sheet(NodesTogether(Random(1), intArrayOf(1, 2, 1))).use { nodes ->
            for (step in 1..80) {
                serial.advance()
                nodes.advance()
                assertSameStep(serial, nodes, "step $step")
            }
        }
        assertTrue(serial.collisions!!.counters.collisions > 1000)
    }

    @Test
    fun `a full slide of the sheet under its cuts changes no bit`() {
        val boundary = HillSheet(Box.centred(12.0, 20.0, 6.0), 0.2)
        val start = randomSpheres(500, boundary, 4, 0.5) { 0.4 }
        val serial = simulationOf(start.copy(), boundary, 0.15, ConstantRestitution(0.7))
        val engine = NodesTogether(Random(1), intArrayOf(1, 2, 1))
        simulationOf(start.copy(), boundary, 0.15, ConstantRestitution(0.7), engine = engine).use { nodes ->
            for (step in 1..40) {
                serial.advance()
                nodes.advance()
                assertSameStep(serial, nodes, "step $step")
            }
        }
        assertTrue(serial.collisions!!.counters.collisions > 1000)
    }

    @Test
    fun `spheres that rest in a box that narrows meet across cuts that move with it`() {
        var collisions = 0L
        for (seed in 1..40L) {
            val sheet = HillSheet(Box.centred(40.0, 3.0, 3.0), 0.1, perturbation = 0.8)
            val from = 42.0
            val start = randomSpheres(40, Periodic(sheet.at(from).box), seed, 0.01) { 0.3 }
            fun narrowing(engine: CollisionEngine) = Simulation(
                start.copy(),
                sheet,
                CollisionForcing(ConstantRestitution(1.0), engine = engine, recordCollisions = true),
                FixedTimeStep(0.7),
                startTime = from,
                startStep = 1,
            )
            val serial = narrowing(SerialEngine())
            narrowing(NodesTogether(Random(seed), intArrayOf(8, 8)) { HaloMargins(0.0, 0.0) }).use { nodes ->
                for (step in 1..6) {
                    serial.advance()
                    nodes.advance()
                    assertSameStep(serial, nodes, "seed $seed, step $step")
                }
            }
            collisions += serial.collisions!!.counters.collisions
        }
        assertTrue(collisions > 60) { "only $collisions" }
    }

    @Test
    fun `two spheres at rest that meet only steps after space was cut meet across the cuts`() {
        val sheet = HillSheet(Box.centred(40.0, 3.0, 3.0), 0.1, perturbation = 0.8)
        var collisions = 0L
        for (k in 0..20) {
            val x = 20.0 + 0.3 * k
            fun narrowing(engine: CollisionEngine) = Simulation(
                populationOf(Sphere(x = -x, r = 0.3), Sphere(x = x, y = 0.1, r = 0.3)),
                sheet,
                CollisionForcing(ConstantRestitution(1.0), engine = engine, recordCollisions = true),
                FixedTimeStep(0.7),
                startTime = 42.0,
                startStep = 1,
            )
            val serial = narrowing(SerialEngine())
            narrowing(NodesTogether(Random(1), intArrayOf(2, 2)) { HaloMargins(0.0, 0.0) }).use { nodes ->
                for (step in 1..6) {
                    serial.advance()
                    nodes.advance()
                    assertSameStep(serial, nodes, "from $x, step $step")
                }
            }
            collisions += serial.collisions!!.counters.collisions
        }
        assertTrue(collisions > 2) { "only $collisions" }
    }

    @Test
    fun `spheres that rest while their images come nearer meet them across the cuts`() {
        val box = Box.centred(24.0, 3.0, 3.0)
        var collisions = 0L
        for (seed in 1..60L) {
            // So few that most bricks have no collision, from which they would learn how far spheres go.
            val start = randomSpheres(40, Periodic(box), seed, 0.01) { 0.3 }
            // In the coordinates of a step nothing moves but images, by two units of length.
            for (axis in 0..2) for (k in 0 until start.size) start.velocity(axis)[k] += 0.09 * start.position(axis)[k]
            fun growing(engine: CollisionEngine) =
                simulationOf(start.copy(), GrowingSpheres(box, 0.09), 1.0, engine = engine)
            val serial = growing(SerialEngine())
            growing(NodesTogether(Random(seed), intArrayOf(8, 8)) { HaloMargins(0.0, 0.0) }).use { nodes ->
                serial.advance()
                nodes.advance()
                assertSameStep(serial, nodes, "seed $seed")
            }
            collisions += serial.collisions!!.counters.collisions
        }
        assertTrue(collisions > 60) { "only $collisions" }
    }

    private companion object {
        /** In mean diameters. */
        val WIDTHS = doubleArrayOf(0.0, 0.0, 0.3, 1.0, 3.0)
    }
}
