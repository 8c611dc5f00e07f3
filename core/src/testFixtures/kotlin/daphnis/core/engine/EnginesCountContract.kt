package daphnis.core.engine

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Walls
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.parallel.Execution
import org.junit.jupiter.api.parallel.ExecutionMode
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicInteger

/** What engines count and record: the same from each, whatever happens on the way. */
@Execution(ExecutionMode.SAME_THREAD)
abstract class EnginesCountContract(private val tested: TestedEngines) {
    /** The serial engine, and each of the module on one thread and on three. */
    private val makers: List<() -> CollisionEngine> = buildList {
        add { SerialEngine() }
        for (name in tested.registry.names) {
            for (threads in listOf(1, 3)) add { tested.make(name, FixedThreads(threads)) }
        }
    }

    private fun counts(forcing: CollisionForcing) = with(forcing.counters) {
        listOf(collisions, wallCollisions, guardActivations, redoneSteps, causalityReplays)
    }

    private fun row(x: DoubleArray, vx: DoubleArray, mass: DoubleArray, radius: Double): Population {
        val n = x.size
        fun zeros() = DoubleArray(n)
        return Population(x, zeros(), zeros(), vx, zeros(), zeros(), DoubleArray(n) { radius }, mass)
    }

    @Test
    fun `a step that throws and is tried again counts once, in every engine`() {
        // A heavy one hits a light one, which outruns its bound, so that the step is redone before it ends.
        fun start() =
            row(doubleArrayOf(0.0, 2.0, 30.0), doubleArrayOf(1.0, 0.0, 0.0), doubleArrayOf(1000.0, 0.001, 1.0), 0.5)
        fun simulation(engine: CollisionEngine, restitution: Restitution) =
            Simulation(start(), Open, CollisionForcing(restitution, engine = engine), FixedTimeStep(20.0))
        val undisturbed = simulation(SerialEngine()) { 1.0 }.also { it.advance() }
        val honest = undisturbed.collisions!!
        assertTrue(honest.counters.redoneSteps > 0)
        for ((kind, make) in makers.withIndex()) {
            var thrown = 0
            for (call in 0..5) {
                val calls = AtomicInteger()
                // Fails until it is repaired: parallel engines leave a step in which it throws to the serial one.
                val broken = AtomicBoolean(true)
                val restitution = Restitution {
                    if (broken.get() && calls.getAndIncrement() >= call) {
                        throw ArithmeticException("on purpose")
                    } else {
                        1.0
                    }
                }
                simulation(make(), restitution).use {
                    val forcing = it.collisions!!
                    val story = "${forcing.engine.name}, call $call"
                    try {
                        it.advance()
                    } catch (e: RuntimeException) {
                        thrown++
                        broken.set(false)
                        assertEquals(List(5) { 0L }, counts(forcing)) { story }
                        it.advance()
                    }
                    assertEquals(stateDigest(undisturbed.population), stateDigest(it.population)) { story }
                    // An engine that has the serial one decide says so in the last count.
                    val decided = if (calls.get() > call && thrown == 0) 1L else 0L
                    assertEquals(counts(honest).dropLast(2), counts(forcing).dropLast(2)) { story }
                    assertEquals(decided, forcing.counters.causalityReplays) { story }
                    // An engine whose search does not rely on the bound does not redo the step. Regions have two ways.
                    val redone = forcing.counters.redoneSteps
                    val either = setOf(0L, honest.counters.redoneSteps)
                    when (forcing.engine.name) {
                        "horizon" -> assertEquals(0L, redone) { story }
                        "actors", "pekko" -> assertTrue(redone in either) { "$story: $redone of $either" }
                        else -> assertEquals(honest.counters.redoneSteps, redone) { story }
                    }
                }
            }
            assertTrue(thrown > 1) { "engine $kind threw $thrown times" }
        }
    }

    @Test
    fun `of collisions at one time every engine records the cause before its effect`() {
        // Rows of touching spheres, each struck at t = 2; the push runs through all ten at that time. Ids are dealt at
        // random, so they do not tell.
        val rows = 24
        val each = 11
        val n = rows * each
        val ids = IntArray(n) { it }
        val random = SeededRandom(5)
        for (k in n - 1 downTo 1) {
            val j = random.nextInt(k + 1)
            ids[k] = ids[j].also { ids[j] = ids[k] }
        }
        val placeOf = IntArray(n).also { for (k in 0 until n) it[ids[k]] = k }
        fun start() = Population(
            DoubleArray(n) { if (it % each == 0) -4.0 else 2.0 * (it % each - 1) },
            DoubleArray(n) { 4.0 * (it / each % 6) },
            DoubleArray(n) { 4.0 * (it / each / 6) },
            DoubleArray(n) { if (it % each == 0) 1.0 else 0.0 },
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n) { 1.0 },
            DoubleArray(n) { 1.0 },
            ids.copyOf(),
        )
        val expected = ArrayList<List<Int>>()
        for (make in makers) {
            val engine = make()
            val forcing = CollisionForcing(ConstantRestitution(1.0), engine = engine, recordCollisions = true)
            Simulation(start(), Open, forcing, FixedTimeStep(4.0)).use { it.advance() }
            val record = forcing.record!!
            assertEquals(rows * (each - 1), record.size) { engine.name }
            val next = IntArray(rows)
            for (k in 0 until record.size) {
                assertEquals(2.0, record.time[k])
                val place = minOf(placeOf[record.lower[k]], placeOf[record.higher[k]])
                assertEquals(next[place / each]++, place % each) { "${engine.name}, collision $k" }
                assertEquals(place % each + 1, record.rank[k]) { "${engine.name}, collision $k" }
            }
            expected += (0 until record.size).map { record.lower[it] * n + record.higher[it] }
        }
        for (k in expected.indices) assertEquals(expected[0], expected[k]) { "engine $k" }
    }

    @Test
    fun `a wall between two collisions at one time passes on which came first`() {
        // 2 strikes 1, which touches 0, which touches the wall: 0 comes back at once, and so does the push.
        val box = Box(0.0, -5.0, -5.0, 20.0, 5.0, 5.0)
        for (make in makers) {
            val engine = make()
            val forcing = CollisionForcing(ConstantRestitution(1.0), engine = engine, recordCollisions = true)
            val start = row(doubleArrayOf(1.0, 3.0, 7.0), doubleArrayOf(0.0, 0.0, -1.0), DoubleArray(3) { 1.0 }, 1.0)
            Simulation(start, Walls(box), forcing, FixedTimeStep(4.0)).use { it.advance() }
            val record = forcing.record!!
            val pairs = (0 until record.size).map { record.lower[it] to record.higher[it] }
            assertEquals(listOf(1 to 2, 0 to 1, 0 to 1, 1 to 2), pairs) { engine.name }
            assertEquals(listOf(1, 2, 3, 4), (0 until record.size).map { record.rank[it] }) { engine.name }
        }
    }
}
