package daphnis.core.cluster

import daphnis.core.collision.CollisionRecord
import daphnis.core.population.Population
import daphnis.core.step.CollapseException
import java.nio.ByteBuffer

/**
 * The leader's side of a crew of [nodes], which hold the spheres.
 *
 * @property step number of steps since the start of the run that the nodes have made
 */
internal class Crew(private val mail: Mail, val nodes: List<FleetNode>, var step: Long) : AutoCloseable {
    /** Whether a step has failed, so that the crew can only be asked for its spheres. */
    var hasFailed = false
        private set

    /** Whether answers are still to come: something was thrown in between. */
    private var isAsking = false

    /** Whether some nodes may have made a step that others have not. */
    private var isTorn = false

    /** Whether the crew cannot be asked for anything more. */
    val mustEnd: Boolean get() = isAsking || isTorn

    private inline fun <T> round(act: () -> T): T {
        isAsking = true
        return act().also { isAsking = false }
    }

    /** Gives each node a part of [population], with which it begins. */
    fun begin(begin: Begin, population: Population): Unit = round {
        val threads = begin.threads.runningFold(0L) { sum, n -> sum + n }
        for (rank in nodes.indices) {
            mail.send(rank, begin.message())
            val from = (population.size * threads[rank] / threads.last()).toInt()
            val until = (population.size * threads[rank + 1] / threads.last()).toInt()
            SpheresWire.send(mail, rank, population, from, until)
        }
    }

    /**
     * One step of all nodes.
     *
     * @return what each has done, by rank
     * @throws RuntimeException what ended the step; then the nodes are as before it, unless the crew [mustEnd]
     */
    fun step(): List<StepDone> {
        val answers = answers(Command.STEP)
        isTorn = true
        val done = ArrayList<StepDone>()
        var failure: RuntimeException? = null
        for ((rank, answer) in answers.withIndex()) {
            when (Answer.entries[answer.get().toInt()]) {
                Answer.DONE -> done += answer.stepDone()
                Answer.FAILED -> failure = failure ?: failure(answer, nodes[rank])
                Answer.FAILED_ELSEWHERE -> Unit
            }
        }
        isTorn = done.size in 1 until nodes.size
        if (done.size < nodes.size) {
            hasFailed = true
            throw failure ?: IllegalStateException("a step has failed on ${nodes.size - done.size} nodes")
        }
        step++
        return done
    }

    /** What serial engines throw is thrown as by them; anything else names the node. */
    private fun failure(answer: ByteBuffer, node: FleetNode): RuntimeException {
        val type = answer.text()
        val message = answer.text()
        return when (type) {
            CollapseException::class.java.name -> CollapseException(message)
            IllegalArgumentException::class.java.name -> IllegalArgumentException(message)
            IllegalStateException::class.java.name -> IllegalStateException(message)
            else -> NodeException("node ${node.name}: $type: $message")
        }
    }

    /** Makes [population] what the nodes hold. When this throws, it is as it was. */
    fun gather(population: Population) {
        round {
            tell(Command.GATHER)
            fetch(population)
        }
    }

    private fun fetch(population: Population) {
        val counts = nodes.indices.map { mail.receive(it).int }
        val columns = population.columnsToWrite(tracksLastCollision = true, counts.sum())
        var at = 0
        val crossings = nodes.indices.map { rank ->
            SpheresWire.receive(mail, rank, counts[rank]) { block ->
                block.copyInto(columns, at)
                at += block.size
            }
            mail.receive(rank)
        }
        population.expect(columns.id, crossings.minOf { it.int })
        if (crossings.any { it.hasRemaining() }) population.crossings.reserve()
        population.take(columns)
        for (message in crossings) {
            while (message.hasRemaining()) {
                val id = message.int
                val axis = message.int
                val boxes = message.int
                // One that has come and gone since the last time is not known here.
                if (population.crossings.has(id)) population.crossings.add(id, axis, boxes)
            }
        }
    }

    /**
     * Asks all nodes for what [command] with the bytes that [write] adds brings, and hands each answer to [read].
     *
     * @throws NodeException when [read] refuses an answer or leaves some of it
     */
    fun ask(command: Command, write: (MessageWriter) -> Unit, read: (ByteBuffer) -> Unit) {
        for ((rank, answer) in answers(command, write).withIndex()) {
            try {
                read(answer)
                require(!answer.hasRemaining()) { "it is ${answer.remaining()} bytes too long" }
            } catch (e: IllegalArgumentException) {
                throw NodeException("node ${nodes[rank].name}: its answer is damaged: ${e.message}")
            }
        }
    }

    /** All are received, whatever is in them, so that the next round begins with its own. */
    private fun answers(command: Command, write: (MessageWriter) -> Unit = {}): List<ByteBuffer> = round {
        tell(command, write)
        nodes.indices.map { mail.receive(it) }
    }

    private fun tell(command: Command, write: (MessageWriter) -> Unit = {}) {
        val question = MessageWriter().byte(command.ordinal).also(write).message()
        for (rank in nodes.indices) mail.send(rank, question.duplicate())
    }

    override fun close() = mail.close()
}

/** Makes this the record of a step that nodes have [done]. */
internal fun CollisionRecord.takeAll(done: List<StepDone>) {
    clear()
    for (part in done.mapNotNull { it.record }) addAll(part, 0, part.size)
    sort()
}

/** A node has failed in a way that no simulation does, such as for lack of memory. */
public class NodeException(message: String) : RuntimeException(message)
