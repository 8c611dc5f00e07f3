package daphnis.app

import com.typesafe.config.ConfigFactory
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.javadsl.Behaviors
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.parallel.Execution
import org.junit.jupiter.api.parallel.ExecutionMode

/**
 * The contract: every engine gives the bits of the serial one, after every step, for every number of threads and every
 * division into regions.
 */
@Execution(ExecutionMode.SAME_THREAD)
class EnginesAgreeTest {
    @Test
    fun `every engine gives the digest, counts and collisions of the serial one after every step of every drawn case`() {
        val host = ActorSystem.create(
            Behaviors.empty<Void>(),
            "host",
            ConfigFactory.parseString("pekko.loglevel=WARNING, pekko.daemonic=on").withFallback(ConfigFactory.load()),
        )
        var collisions = 0L
        var replays = 0L
        var failures = 0
        asked = 0
        try {
            for (seed in FIRST..FIRST + DRAWS - 1) {
                val case = if (seed % 3 == 0L) OddDraw(seed) else Draw(seed)
                val serial = case.simulation(SerialEngine())
                val others = case.engines(host).map { case.simulation(it) }
                try {
                    if (!agree(case, serial, others)) failures++
                } finally {
                    others.forEach { it.close() }
                }
                collisions += serial.collisions!!.counters.collisions
                replays += others.sumOf { it.collisions!!.counters.causalityReplays }
            }
        } finally {
            host.terminate()
        }
        println(
            "$DRAWS draws, $collisions collisions an engine, $replays replays, $failures that end by an exception, $asked steps with every pair asked",
        )
        assertTrue(collisions > 100 * DRAWS) { "only $collisions collisions" }
        assertTrue(DRAWS < 250 || (failures > 0 && asked > 100)) {
            "$failures cases fail, $asked steps asked: the draws do not test what they should"
        }
    }

    private var asked = 0

    /** @return whether the serial engine, and so all, came to the end; else all threw the same */
    private fun agree(case: Case, serial: Simulation, others: List<Simulation>): Boolean {
        val asking = EveryPairEngine()
        val oracle = case.simulation(asking)
        var isAsked = true
        for (step in 1..STEPS) {
            isAsked = isAsked && asking.canDo(case, serial.population, case.dt)
            if (isAsked) asking.prepare(case, serial.population, case.dt)
            val expected = failure(serial)
            if (expected != null) {
                for (other in others) {
                    val name = other.collisions!!.engine.name
                    assertEquals(expected, failure(other)) { "$case, step $step, $name" }
                    assertEquals(stateDigest(serial.population), stateDigest(other.population)) {
                        "$case, step $step, $name"
                    }
                }
                return false
            }
            for (other in others) {
                val story = "$case, step $step, ${other.collisions!!.engine.name} on ${other.collisions!!.engine.threads}"
                assertEquals(null, failure(other)) { story }
                compare(serial, other, story)
            }
            if (!isAsked) continue
            oracle.advance()
            compare(serial, oracle, "$case, step $step, every pair asked")
            asked++
        }
        return true
    }

    @Test
    fun `islands of very many spheres give the digest of the serial engine over a hundred steps, whichever way they take them`() {
        val random = SeededRandom(11)
        val n = 21_000
        fun drawn(scale: Double, at: (Int) -> Int) = DoubleArray(n) {
            2.6 * at(it) +
                scale * random.nextDouble(-1.0, 1.0)
        }
        val x = drawn(0.2) { it % 28 }
        val y = drawn(0.2) { it / 28 % 28 }
        val z = drawn(0.2) { it / 28 / 28 }
        fun gauss() = DoubleArray(n) { random.nextGaussian() }
        val start = Population(x, y, z, gauss(), gauss(), gauss(), DoubleArray(n) { 1.0 }, DoubleArray(n) { 1.0 })
        val boundary = Periodic(Box(-1.3, -1.3, -1.3, 71.5, 71.5, 71.5))
        fun simulation(engine: CollisionEngine) = Simulation(
            start.copy(),
            boundary,
            CollisionForcing(ConstantRestitution(0.9), engine = engine),
            FixedTimeStep(0.02),
        )
        val serial = simulation(SerialEngine())
        simulation(IslandsEngine(FixedPool(3))).use { islands ->
            for (step in 1..100) {
                serial.advance()
                islands.advance()
                if (step % 10 == 0) {
                    assertEquals(stateDigest(serial.population), stateDigest(islands.population)) { "step $step" }
                }
            }
            assertEquals(serial.collisions!!.counters.collisions, islands.collisions!!.counters.collisions)
        }
    }

    @Test
    fun `no sphere, one, and a boundary that removes more of them each step`() {
        val floor = object : BoundaryConditions {
            override val box = Box.UNBOUNDED

            override fun endStep(population: Population, time: Double) = population.retain {
                population.id[it] >=
                    100 * time
            }
        }
        for (count in listOf(0, 1, 400)) {
            val start = Population(
                DoubleArray(count) { it % 8 * 1.2 },
                DoubleArray(count) { it / 8 % 8 * 1.2 },
                DoubleArray(count) { it / 64 * 1.2 },
                DoubleArray(count) { Math.sin(1.0 * it) },
                DoubleArray(count) { Math.cos(2.0 * it) },
                DoubleArray(count),
                DoubleArray(count) { 0.5 },
                DoubleArray(count) { 1.0 },
            )
            val digests =
                listOf(SerialEngine(), IslandsEngine(FixedPool(3), fewest = 0)) +
                    listOf("thread-pool", "actors", "pekko").map { allEngines.create(it, 3)!! }
            val ends = digests.map { engine ->
                Simulation(
                    start.copy(),
                    floor,
                    CollisionForcing(ConstantRestitution(1.0), engine = engine),
                    FixedTimeStep(0.5),
                ).use {
                    repeat(10) { _ -> it.advance() }
                    engine.name to stateDigest(it.population)
                }
            }
            for ((name, digest) in ends) assertEquals(ends[0].second, digest) { "$count spheres, $name" }
        }
    }

    /** Advances; what was thrown, or null. */
    private fun failure(simulation: Simulation): String? = try {
        simulation.advance()
        null
    } catch (e: RuntimeException) {
        "${e.javaClass.name}: ${e.message}"
    }

    private fun compare(serial: Simulation, other: Simulation, story: String) {
        assertEquals(stateDigest(serial.population), stateDigest(other.population)) { story }
        val a = serial.collisions!!
        val b = other.collisions!!
        fun counts(f: CollisionForcing) = with(f.counters) { listOf(collisions, wallCollisions, guardActivations) }
        assertEquals(counts(a), counts(b)) { story }
        val r = a.record!!
        val s = b.record!!
        assertEquals(r.size, s.size) { story }
        for (k in 0 until r.size) {
            val same = r.time[k] == s.time[k] &&
                r.rank[k] == s.rank[k] &&
                r.lower[k] == s.lower[k] &&
                r.higher[k] == s.higher[k] &&
                r.impulse(k) == s.impulse(k) &&
                (0..2).all { r.separation(k, it) == s.separation(k, it) }
            assertTrue(same) { "$story: collision $k differs" }
        }
    }

    private companion object {
        val LONG = System.getProperty("daphnis.long") == "true"
        val DRAWS = Integer.getInteger("daphnis.draws", if (LONG) 5000 else 250).toLong()
        val FIRST = Integer.getInteger("daphnis.firstDraw", 1).toLong()
        const val STEPS = 3
    }
}
