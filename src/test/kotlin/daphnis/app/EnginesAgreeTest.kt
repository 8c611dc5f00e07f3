package daphnis.app

import com.typesafe.config.ConfigFactory
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
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

/** The contract: every engine gives the bits of the serial one, after every step, for every number of threads and every division into regions. */
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
        try {
            for (seed in FIRST..FIRST + DRAWS - 1) {
                val draw = Draw(seed)
                val serial = draw.simulation(SerialEngine())
                val others = draw.engines(host).map { draw.simulation(it) }
                try {
                    for (step in 1..STEPS) {
                        if (isRefused(serial)) {
                            // So long a step that images too far away would matter: all say so, and leave the population alone.
                            for (other in others) {
                                assertTrue(isRefused(other)) { "$draw, ${other.collisions!!.engine.name}" }
                                assertEquals(stateDigest(serial.population), stateDigest(other.population))
                            }
                            break
                        }
                        for (other in others) {
                            other.advance()
                            compare(serial, other, "$draw, step $step, ${other.collisions!!.engine.name} on ${other.collisions!!.engine.threads}")
                        }
                    }
                } finally {
                    others.forEach { it.close() }
                }
                collisions += serial.collisions!!.counters.collisions
                replays += others.sumOf { it.collisions!!.counters.causalityReplays }
            }
        } finally {
            host.terminate()
        }
        println("$DRAWS draws, $collisions collisions an engine, $replays replays")
        assertTrue(collisions > 100 * DRAWS) { "only $collisions collisions" }
    }

    @Test
    fun `no sphere, one, and a boundary that removes more of them each step`() {
        val floor = object : BoundaryConditions {
            override val box = Box.UNBOUNDED

            override fun endStep(population: Population, time: Double) = population.retain { population.id[it] >= 100 * time }
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
            val digests = listOf(SerialEngine(), IslandsEngine(FixedPool(3), fewest = 0)) + listOf("thread-pool", "actors", "pekko").map { allEngines.create(it, 3)!! }
            val ends = digests.map { engine ->
                Simulation(start.copy(), floor, CollisionForcing(ConstantRestitution(1.0), engine = engine), FixedTimeStep(0.5)).use {
                    repeat(10) { _ -> it.advance() }
                    engine.name to stateDigest(it.population)
                }
            }
            for ((name, digest) in ends) assertEquals(ends[0].second, digest) { "$count spheres, $name" }
        }
    }

    /** Advances, unless the engine refuses so long a step. */
    private fun isRefused(simulation: Simulation): Boolean = try {
        simulation.advance()
        false
    } catch (e: IllegalArgumentException) {
        true
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
