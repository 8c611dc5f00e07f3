package daphnis.cluster.link

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.ByteBuffer
import kotlin.random.Random

/** Both halves of a link on one thread, with a wire that is none of the best, and a clock of the test. */
class LinkTest {
    private val limits = LinkLimits(chunk = 16, window = 64, waiting = 200, message = 5000, patience = 10, longest = 40)
    private val wire = ArrayList<LinkMessage>()
    private val outbox = Outbox(CREW, 0, 1, limits, wire::add)
    private val inbox = Inbox(CREW, 0, 1, limits, wire::add)
    private var now = 0L

    private fun deliver(message: LinkMessage) {
        when (message) {
            is Chunk -> inbox.take(message)
            is Receipt -> outbox.acknowledge(message.next, message.limit, now)
            is Probe -> inbox.acknowledge()
        }
    }

    private fun deliverAll() {
        while (wire.isNotEmpty()) deliver(wire.removeFirst())
    }

    private fun tick() {
        now++
        outbox.tick(now)
        inbox.tick()
    }

    @ParameterizedTest
    @ValueSource(ints = [1, 2, 3, 4, 5, 6, 7, 8])
    fun `all messages arrive once and in order, whatever the wire does`(seed: Int) {
        val random = Random(seed)
        val sent = List(100) { random.nextBytes(if (it % 3 == 0) random.nextInt(5) else random.nextInt(300)) }
        val arrived = ArrayList<ByteBuffer>()
        var next = 0
        var rounds = 0
        while (arrived.size < sent.size) {
            check(++rounds < 1_000_000) { "seed $seed: only ${arrived.size} messages have arrived" }
            if (next < sent.size && random.nextInt(4) == 0) outbox.send(ByteBuffer.wrap(sent[next++]), now)
            if (wire.isNotEmpty()) trouble(random)
            if (random.nextInt(3) == 0) inbox.poll()?.let(arrived::add)
            tick()
        }
        assertEquals(sent.map { ByteBuffer.wrap(it) }, arrived)
        repeat(2000) {
            tick()
            deliverAll()
        }
        assertNull(inbox.poll())
        assertEquals(0, outbox.pending)
        assertEquals(0, outbox.bytesOnTheWay)
    }

    /** Loses, doubles, damages, swaps, or delivers. */
    private fun trouble(random: Random) {
        val message = wire.removeAt(if (random.nextInt(5) == 0) random.nextInt(wire.size) else 0)
        when (random.nextInt(10)) {
            0 -> Unit
            1 -> repeat(2) { deliver(message) }
            2 -> deliver(if (message is Chunk) damaged(message, random) else message)
            3 -> wire.add(random.nextInt(wire.size + 1), message)
            else -> deliver(message)
        }
    }

    /** [chunk] with a bit flipped, in its piece or in what stands before it. */
    private fun damaged(chunk: Chunk, random: Random): Chunk {
        val bytes = ByteArray(chunk.bytes.remaining()).also(chunk.bytes.duplicate()::get)
        val bit = random.nextInt(8 * bytes.size + 96)
        if (bit < 8 * bytes.size) bytes[bit / 8] = (bytes[bit / 8].toInt() xor (1 shl bit % 8)).toByte()
        val place = bit - 8 * bytes.size
        fun flip(value: Int, at: Int) = if (place in at until at + 32) value xor (1 shl place - at) else value
        return Chunk(
            CREW,
            0,
            1,
            flip(chunk.number.toInt(), 0).toLong(),
            flip(chunk.length, 32),
            flip(chunk.offset, 64),
            ByteBuffer.wrap(bytes),
            chunk.check,
        )
    }

    @Test
    fun `no more than the window is handed to the wire`() {
        outbox.send(ByteBuffer.allocate(1000), now)
        assertEquals(64, wire.sumOf { (it as Chunk).bytes.remaining() })
        repeat(5) { outbox.send(ByteBuffer.allocate(1000), now) }
        assertEquals(4, wire.size)
        deliverAll()
        assertTrue(outbox.bytesOnTheWay <= 64)
    }

    @Test
    fun `short messages fill the window by their number`() {
        repeat(1000) { outbox.send(ByteBuffer.allocate(0), now) }
        assertEquals((200 + 64) / 16, wire.size)
    }

    @Test
    fun `a receiver that takes nothing lets no more in than a window beyond its limit`() {
        repeat(100) { outbox.send(ByteBuffer.allocate(100), now) }
        repeat(1000) {
            tick()
            deliverAll()
        }
        val most = limits.waiting + limits.window + 100
        assertTrue(inbox.bytesWaiting in limits.waiting..most) { "${inbox.bytesWaiting} bytes wait" }
        assertTrue(outbox.pending > 0)
        var taken = 0
        repeat(10_000) {
            inbox.poll()?.let { taken++ }
            tick()
            deliverAll()
        }
        assertEquals(100, taken)
    }

    @Test
    fun `a lost permission is asked for`() {
        repeat(100) { outbox.send(ByteBuffer.allocate(100), now) }
        repeat(200) {
            tick()
            deliverAll()
        }
        while (inbox.poll() != null) wire.clear()
        var waited = 0
        while (wire.none { it is Probe }) {
            check(waited++ < 100) { "no probe" }
            tick()
        }
        deliverAll()
        assertTrue(inbox.hasMessage)
    }

    @Test
    fun `waits between attempts grow up to the longest`() {
        outbox.send(ByteBuffer.allocate(1), now)
        val times = ArrayList<Long>()
        repeat(200) {
            wire.clear()
            tick()
            if (wire.isNotEmpty()) times += now
        }
        assertEquals(listOf(10L, 30L, 70L, 110L, 150L, 190L), times)
    }

    @Test
    fun `a length beyond the limit is refused on both sides before memory is taken`() {
        assertThrows(IllegalArgumentException::class.java) { outbox.send(ByteBuffer.allocate(5001), now) }
        for (length in listOf(5001, Int.MAX_VALUE, -1)) {
            assertThrows(LinkException::class.java) { inbox.take(chunk(0, length, 0, 16)) }
        }
    }

    @Test
    fun `a piece that does not fit its message is refused`() {
        inbox.take(chunk(0, 40, 0, 16))
        val wrong = listOf(Triple(41, 16, 16), Triple(40, 17, 16), Triple(40, 16, 25), Triple(40, 16, 0))
        for ((length, offset, size) in wrong) {
            assertThrows(LinkException::class.java) { inbox.take(chunk(1, length, offset, size)) }
        }
        assertFalse(inbox.take(chunk(1, 40, 16, 16)))
        assertTrue(inbox.take(chunk(2, 40, 32, 8)))
    }

    @Test
    fun `a receipt for what was never sent is ignored`() {
        outbox.send(ByteBuffer.allocate(1000), now)
        outbox.acknowledge(5, 100, now)
        assertEquals(64, outbox.bytesOnTheWay)
        outbox.acknowledge(4, 100, now)
        outbox.acknowledge(2, 100, now)
        assertEquals(63 - 4, outbox.pending)
    }

    private fun chunk(number: Long, length: Int, offset: Int, size: Int): Chunk {
        val bytes = ByteBuffer.allocate(size)
        val check = Chunk.checkOf(CREW, 0, 1, number, length, offset, bytes)
        return Chunk(CREW, 0, 1, number, length, offset, bytes, check)
    }

    private companion object {
        const val CREW = 77L
    }
}
