package daphnis.core.cluster

import daphnis.core.Engines
import daphnis.core.population.stateDigest
import daphnis.core.run.Run
import daphnis.core.run.RunException
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.ByteBuffer
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread

/** Faults at awkward places: in copies, between a step and its answer, in what a crew does first, and at the end. */
@Timeout(60)
class NodeFaultsTest {
    @TempDir
    lateinit var home: Path
    private val lines = ArrayList<String>()

    private var case = RowCase.SHEARED

    private fun scenario(vararg settings: String) = ScenarioJson.parse(case.text, "test", settings.toList())

    private fun start(
        fleet: Fleet,
        copies: CopyClock = CopyClock { 0 },
        patience: Duration = Duration.ZERO,
        name: String = "nodes",
    ) = Run.start(
        scenario(),
        "test",
        home.resolve(name),
        engines = FleetEngines(fleet, patience, {
            lines += it
        }, copies),
    )

    /** A clock by which a copy is always due. */
    private fun always(): CopyClock {
        var now = 0L
        return CopyClock { now.also { now += 10_000_000_000 } }
    }

    /** A step of [run] in a thread of its own; what it throws is [thrown]. */
    private fun stepping(run: Run, thrown: AtomicReference<Throwable>): Thread = thread {
        try {
            run.simulation.advance()
        } catch (e: Throwable) {
            thrown.set(e)
        }
    }

    private fun serialDigest(steps: Int): String {
        val one = scenario("engine.name=serial")
        return Run.start(one, "test", home.resolve("serial"), force = true, engines = Engines).use { run ->
            repeat(steps) { run.simulation.advance() }
            stateDigest(run.simulation.population)
        }
    }

    private fun isGather(from: Int, message: ByteBuffer) = from == Mail.LEADER &&
        message.remaining() == 1 &&
        message.get(message.position()).toInt() == Command.GATHER.ordinal

    @Test
    fun `a copy for safety that cannot be had takes back no step that stands`() {
        val fleet = ThreadFleet(1)
        fleet.onSend = { from, _, message -> if (isGather(from, message)) fleet.kill(0) }
        start(fleet, always()).use { run ->
            val simulation = run.simulation
            repeat(2) {
                try {
                    simulation.advance()
                } catch (_: FleetException) {
                    // There is no node any more.
                }
            }
            fleet.onSend = { _, _, _ -> }
            fleet.add()
            assertEquals(serialDigest(simulation.step.toInt()), stateDigest(simulation.population))
            val counted = simulation.collisions!!.counters.collisions
            assertTrue(counted > 0) { "$counted" }
            simulation.advance()
            assertEquals(serialDigest(simulation.step.toInt()), stateDigest(simulation.population))
        }
    }

    @Test
    fun `a node that fails when it has done its part of a step takes back the step of all`() {
        // Too few to collide: no attempt at a step is made again, in which a node may have nothing to say, too.
        case = RowCase.FEW
        val fleet = ThreadFleet(2)
        // The state at the start, and two steps, stand.
        val left = AtomicInteger(1 + 2 + 1)
        fleet.onSend = { from, to, message ->
            val isAgreement = from == 1 && to == 0 && message.remaining() == NOTHING_TO_ALL
            if (isAgreement && left.decrementAndGet() == 0) error("it has failed late")
        }
        start(fleet).use { run ->
            val simulation = run.simulation
            repeat(2) { simulation.advance() }
            val e = assertThrows(IllegalStateException::class.java) { simulation.advance() }
            assertEquals("it has failed late", e.message)
            // Not made again from the start: the nodes are as before the step.
            assertEquals(serialDigest(2), stateDigest(simulation.population))
            assertEquals(1, fleet.crews)
            simulation.advance()
            assertEquals(serialDigest(3), stateDigest(simulation.population))
        }
    }

    @Test
    fun `a node that fails while messages go around ends the crew, and the next one makes the step`() {
        val fleet = ThreadFleet(3)
        val left = AtomicInteger(40)
        // Of three nodes the second tells the first what it has heard before; that message says so in its first byte.
        fleet.onSend = { from, to, message ->
            val isSecond = from == 1 && to == 0 && message.get(message.position()).toInt() == 0
            if (isSecond && left.decrementAndGet() == 0) throw OutOfMemoryError("made up")
        }
        start(fleet).use { run ->
            repeat(12) { run.simulation.advance() }
            assertEquals(serialDigest(12), stateDigest(run.simulation.population))
        }
        assertTrue(left.get() < 0) { "${left.get()}" }
        assertEquals(2, fleet.crews)
    }

    @Tag("thorough")
    @Test
    fun `nodes that end whenever they begin end the run with the reason`() {
        val fleet = ThreadFleet(2)
        var begun = 0
        val failing = object : Fleet by fleet {
            override fun form(nodes: List<FleetNode>): Mail {
                val mail = fleet.form(nodes)
                if (begun++ > 50) error("for ever")
                return object : Mail by mail {
                    override fun receive(from: Int): ByteBuffer = throw MailClosedException("OutOfMemoryError: heap")
                }
            }
        }
        start(failing).use { run ->
            val e = assertThrows(RunException::class.java) { run.execute() }
            assertTrue("10 times and ended: OutOfMemoryError: heap" in e.message.orEmpty()) { e.message.orEmpty() }
        }
    }

    @Test
    fun `no crew begins after the end`() {
        val fleet = ThreadFleet(2)
        val run = start(fleet)
        run.simulation.advance()
        run.close()
        assertThrows(IllegalStateException::class.java) { run.simulation.population }
        assertEquals(1, fleet.crews)
    }

    @Test
    fun `closing while a crew is formed ends that crew`() {
        val fleet = ThreadFleet(1)
        val forming = CountDownLatch(1)
        val closed = CountDownLatch(1)
        val late = AtomicReference<Mail>()
        val slow = object : Fleet by fleet {
            override fun form(nodes: List<FleetNode>): Mail {
                forming.countDown()
                closed.await()
                return fleet.form(nodes).also { late.set(it) }
            }

            override fun close() = Unit
        }
        val run = start(slow)
        val thrown = AtomicReference<Throwable>()
        val stepping = stepping(run, thrown)
        forming.await()
        run.close()
        closed.countDown()
        stepping.join()
        assertEquals("the simulation is closed", thrown.get()?.message)
        assertTrue(late.get().isClosed)
        fleet.close()
    }

    @Test
    fun `closing ends the wait for a node`() {
        val fleet = ThreadFleet(0)
        val waiting = CountDownLatch(1)
        val watched = object : Fleet by fleet {
            override fun nodes(): List<FleetNode> = fleet.nodes().also { waiting.countDown() }
        }
        val run = start(watched, patience = Duration.ofHours(1))
        val thrown = AtomicReference<Throwable>()
        val stepping = stepping(run, thrown)
        waiting.await()
        run.close()
        stepping.join()
        assertEquals("the simulation is closed", thrown.get()?.message)
    }

    @Test
    fun `a node that comes as another goes is told of`() {
        val fleet = ThreadFleet(2)
        start(fleet).use { run ->
            run.simulation.advance()
            assertEquals(900, run.simulation.population.size)
            fleet.add()
            fleet.kill(0)
            run.simulation.advance()
            assertTrue("1 node has come" in lines) { "$lines" }
            assertEquals(2, fleet.crews)
            assertEquals(serialDigest(2), stateDigest(run.simulation.population))
        }
    }

    private companion object {
        /** Bytes of a turn between two nodes in which nothing is said: no message for one, and one that is empty. */
        const val NOTHING_TO_ALL = 1 + Int.SIZE_BYTES + Int.SIZE_BYTES + (Int.SIZE_BYTES + 1)
    }
}
