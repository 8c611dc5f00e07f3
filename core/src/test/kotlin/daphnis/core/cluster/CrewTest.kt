package daphnis.core.cluster

import daphnis.core.Sphere
import daphnis.core.collision.CollisionCounters
import daphnis.core.population.IdPlaces
import daphnis.core.populationOf
import daphnis.core.step.CollapseException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.ByteBuffer

class CrewTest {
    /** The mail of a leader to whom the nodes give these [answers]. */
    private class Answers(private val answers: List<MessageWriter>) : Mail {
        override val rank = Mail.LEADER
        override val size = answers.size
        override val isClosed = false

        override fun send(to: Int, body: ByteBuffer) = Unit

        override fun receive(from: Int): ByteBuffer = answers[from].message()

        override fun close() = Unit
    }

    private fun crew(vararg answers: MessageWriter) =
        Crew(Answers(answers.toList()), answers.indices.map { FleetNode("host:$it", 1, 0) }, 0)

    private fun failed(type: String, message: String) =
        MessageWriter().byte(Answer.FAILED.ordinal).text(type).text(message)

    private fun elsewhere() = MessageWriter().byte(Answer.FAILED_ELSEWHERE.ordinal).text("").text("on another")

    private fun done() = MessageWriter().byte(Answer.DONE.ordinal).stepDone(stepDone())

    private fun stepDone(halo: Int = 1, bytes: Long = 0, redone: Long = 0) = StepDone(
        1.0, 0.5, 10, 5, 0.1,
        DoubleArray(
            1,
        ),
        NodeCost(redone, halo, bytes), CollisionCounters(), null, null, null,
    )

    @Test
    fun `what ends a step in the serial engine is thrown as by it, whichever node says so`() {
        val collapse = crew(elsewhere(), failed(CollapseException::class.java.name, "collapse"))
        assertEquals("collapse", assertThrows(CollapseException::class.java) { collapse.step() }.message)
        assertTrue(collapse.hasFailed)
        assertFalse(collapse.mustEnd)
        val refused = crew(failed("java.lang.IllegalArgumentException", "too far"), elsewhere())
        assertEquals("too far", assertThrows(IllegalArgumentException::class.java) { refused.step() }.message)
        val infinite = crew(failed("java.lang.IllegalStateException", "not finite"), done())
        assertEquals("not finite", assertThrows(IllegalStateException::class.java) { infinite.step() }.message)
    }

    @Test
    fun `other failures name the node`() {
        val crew = crew(done(), failed("java.lang.OutOfMemoryError", "Java heap space"))
        val e = assertThrows(NodeException::class.java) { crew.step() }
        assertEquals("node host:1: java.lang.OutOfMemoryError: Java heap space", e.message)
        assertEquals(0, crew.step)
        assertTrue(crew.mustEnd)
    }

    @Test
    fun `nobody is asked again after an answer that cannot be read`() {
        val crew = crew(done(), MessageWriter().byte(Answer.DONE.ordinal))
        assertThrows(RuntimeException::class.java) { crew.step() }
        assertTrue(crew.mustEnd)
    }

    @Test
    fun `a step that all have done counts`() {
        val crew = crew(done(), done())
        assertEquals(listOf(5, 5), crew.step().map { it.held })
        assertEquals(1, crew.step)
    }

    @Test
    fun `boxes crossed that no memory holds leave the population as it was`() {
        val room = MailRoom(1)
        val part = populationOf(Sphere(x = 5.0, r = 0.1))
        part.crossings.add(0, 1, 3)
        SpheresWire.send(room.mail(0), Mail.LEADER, part)
        val home = populationOf(Sphere(x = 1.0, r = 0.1))
        // More places than an array can have.
        home.beginPart(IdPlaces.like(null, Int.MAX_VALUE), areFew = false)
        val crew = Crew(room.mail(Mail.LEADER), listOf(FleetNode("host:0", 1, 0)), 0)
        assertThrows(OutOfMemoryError::class.java) { crew.gather(home) }
        assertEquals(1.0, home.x[0])
    }

    @Test
    fun `the report adds up over crews, whose nodes count anew`() {
        val report = CrewReport()
        assertEquals(null, report.line())
        report.add(listOf(stepDone(2, 3000, 1), stepDone(1, 1000, 1)))
        report.add(listOf(stepDone(2, 5000, 1), stepDone(1, 3000, 1)))
        report.add(listOf(stepDone(0, 400, 2)))
        report.add(listOf(stepDone(0, 600, 5)))
        val share = "15.0 % of the spheres in halos"
        assertEquals("1 node at the end: $share, 6 steps computed again, 2 kB per step", report.line())
    }
}
