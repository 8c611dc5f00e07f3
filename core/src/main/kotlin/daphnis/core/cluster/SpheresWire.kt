package daphnis.core.cluster

import daphnis.core.population.PartNews
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.optional

/** Any number of spheres as messages of limited length. */
internal object SpheresWire {
    /** Sends the entries [from] until [until] of [spheres]. */
    fun send(mail: Mail, to: Int, spheres: SphereColumns, from: Int, until: Int) {
        val head = MessageWriter().int(until - from).byte(spheres.optional)
        mail.send(to, head.message())
        var at = from
        while (at < until) {
            val end = minOf(until, at + BLOCK)
            val message = MessageWriter(SphereBlock.bytes(spheres, end - at))
            SphereBlock.write(message, spheres, at, end)
            mail.send(to, message.message())
            at = end
        }
    }

    /** Receives what [send] has sent. */
    fun receive(mail: Mail, from: Int): PopulationColumns {
        val head = mail.receive(from)
        val count = head.int
        // Told apart from the blocks, of which there may be none.
        val optional = head.get().toInt()
        val blocks = ArrayList<PopulationColumns>()
        receive(mail, from, count) { blocks += it }
        return blocks.singleOrNull() ?: PopulationColumns.joined(blocks, optional)
    }

    /** Receives the [count] spheres that follow their number, and hands each message of them to [take]. */
    inline fun receive(mail: Mail, from: Int, count: Int, take: (PopulationColumns) -> Unit) {
        var received = 0
        while (received < count) {
            val block = SphereBlock.read(mail.receive(from))
            received += block.size
            take(block)
        }
    }

    /** Sends all of [population] and, since the last time, from which id on spheres are new and what boxes were crossed. */
    fun send(mail: Mail, to: Int, population: Population) {
        send(mail, to, population, 0, population.size)
        val message = MessageWriter().int(population.news?.takeBorn() ?: PartNews.NONE)
        population.crossings.drain { id, axis, boxes -> message.int(id).int(axis).int(boxes) }
        mail.send(to, message.message())
    }

    private const val BLOCK = 1 shl 20
}
