package daphnis.core

import daphnis.core.boundary.Open
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** How a simulation treats its outputs. */
class OutputsTest {
    private val calls = ArrayList<String>()

    private inner class Told(private val name: String, private val fails: (String) -> Boolean = { false }) : Output {
        override fun open(simulation: Simulation, opening: Opening) = call("open $opening")

        override fun write(simulation: Simulation) = call("write ${simulation.step}")

        override fun close() = call("close")

        private fun call(what: String) {
            calls += "$name $what"
            check(!fails(what)) { "$name fails" }
        }
    }

    private fun simulation(vararg outputs: Output, startStep: Long = 0) = Simulation(
        populationOf(Sphere(vx = 1.0)),
        Open,
        null,
        FixedTimeStep(1.0),
        outputs = outputs.asList(),
        startStep = startStep,
    )

    @Test
    fun `each is opened once, sees every state, and is closed once, last to first`() {
        simulation(Told("a"), Told("b")).use {
            it.open()
            it.advance()
            it.close()
        }
        val opened = listOf("a open START", "b open START")
        val written = listOf("a write 0", "b write 0", "a write 1", "b write 1")
        assertEquals(opened + written + listOf("b close", "a close"), calls)
    }

    @Test
    fun `at a later step they are told of a resume and are not shown where it stands`() {
        simulation(Told("a"), startStep = 3).use { it.advance() }
        assertEquals(listOf("a open RESUME", "a write 4", "a close"), calls)
    }

    @Test
    fun `one that cannot be opened is asked again and was not closed, nor is one that never was opened`() {
        simulation(Told("a")).close()
        assertEquals(emptyList<String>(), calls)
        var full = true
        val simulation = simulation(Told("a"), Told("b") { full && it.startsWith("open") })
        assertThrows(IllegalStateException::class.java) { simulation.advance() }
        full = false
        simulation.advance()
        simulation.close()
        val opened = listOf("a open START", "b open START", "b open START")
        val written = listOf("a write 0", "b write 0", "a write 1", "b write 1")
        assertEquals(opened + written + listOf("b close", "a close"), calls)
    }

    @Test
    fun `all are closed though one fails to, and the failure is told`() {
        val simulation = simulation(Told("a"), Told("b") { it == "close" }, Told("c"))
        simulation.open()
        assertThrows(IllegalStateException::class.java) { simulation.close() }
        assertEquals(listOf("c close", "b close", "a close"), calls.takeLast(3))
        simulation.close()
        assertEquals(9, calls.size) { "$calls" }
    }

    @Test
    fun `what an output throws is not lost to what closing throws afterwards`() {
        val first = IllegalArgumentException("first")
        val closing = Output {
            it.close()
            throw first
        }
        val simulation = simulation(Told("a") { it == "close" }, closing)
        assertSame(first, assertThrows(IllegalArgumentException::class.java) { simulation.advance() })
        assertEquals(listOf("a fails"), first.suppressed.map { it.message })
        assertEquals(listOf("a open START", "a write 0", "a close"), calls)
    }

    @Test
    fun `an output that closes the simulation is closed when all have seen the step`() {
        val simulation = simulation(Output { if (it.step == 1L) it.close() }, Told("b"))
        simulation.advance()
        assertEquals(listOf("b open START", "b write 0", "b write 1", "b close"), calls)
        assertThrows(IllegalStateException::class.java) { simulation.advance() }
    }

    @Test
    fun `closed from another thread while it looks, an output is closed afterwards by the thread that drives`() {
        val looks = CountDownLatch(1)
        val isClosed = CountDownLatch(1)
        var closer: Thread? = null
        val slow = object : Output {
            var isLooking = false

            override fun write(simulation: Simulation) {
                isLooking = true
                looks.countDown()
                check(isClosed.await(60, TimeUnit.SECONDS))
                isLooking = false
            }

            override fun close() {
                check(!isLooking)
                closer = Thread.currentThread()
            }
        }
        val simulation = simulation(slow)
        val other = thread {
            looks.await()
            simulation.close()
            isClosed.countDown()
        }
        simulation.open()
        other.join()
        assertEquals(Thread.currentThread(), closer)
    }
}
