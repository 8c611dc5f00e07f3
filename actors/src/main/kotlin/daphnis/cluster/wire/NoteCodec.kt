package daphnis.cluster.wire

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.wire.Note.Challenge
import daphnis.cluster.wire.Note.Farewell
import daphnis.cluster.wire.Note.Hello
import daphnis.cluster.wire.Note.Order
import daphnis.cluster.wire.Note.Phase
import daphnis.cluster.wire.Note.Proof
import daphnis.cluster.wire.Note.Refusal
import daphnis.cluster.wire.Note.Standing
import daphnis.cluster.wire.Note.State
import daphnis.cluster.wire.Note.Welcome
import java.nio.ByteBuffer

/**
 * Notes as bytes: a letter for the kind, the sender, and the fields in their order, big-endian; texts and random
 * numbers with their length before them. What does not fit is an [IllegalArgumentException] or a
 * [java.nio.BufferUnderflowException]; no length is believed beyond the bytes that are there. Strangers write notes too:
 * names of hosts and versions are short and of plain characters, all other texts are bounded.
 */
internal object NoteCodec {
    fun write(note: Note, to: ByteBuffer) {
        to.put(kindOf(note)).peer(note.from)
        when (note) {
            is Hello -> to.putInt(note.protocol).text(note.version).bytes(note.nonce)
            is Challenge -> to.bytes(note.hello).bytes(note.nonce).bytes(note.proof)
            is Proof -> to.bytes(note.hello).bytes(note.proof).put(if (note.isMember) 1 else 0)
            is Welcome -> to.bytes(note.hello).putInt(note.threads).put(if (note.isMember) 1 else 0)
            is Refusal -> to.bytes(note.hello).text(note.reason)
            is Order -> {
                to.putLong(note.session).putLong(note.number).putLong(note.key).put(note.phase.ordinal.toByte())
                to.putInt(note.rank).text(note.run).putInt(note.members.size)
                for (member in note.members) to.peer(member)
            }
            is Standing -> to.putLong(note.session).putLong(note.key).put(note.state.ordinal.toByte()).text(note.words)
            is Farewell -> to.putLong(note.session)
        }
    }

    fun read(from: ByteBuffer): Note {
        val kind = from.get()
        val peer = from.peer()
        return when (kind) {
            'H'.code.toByte() -> Hello(peer, from.getInt(), from.text(VERSION), from.bytes())
            'C'.code.toByte() -> Challenge(peer, from.bytes(), from.bytes(), from.bytes())
            'P'.code.toByte() -> Proof(peer, from.bytes(), from.bytes(), from.get() == 1.toByte())
            'W'.code.toByte() -> Welcome(peer, from.bytes(), from.getInt(), from.get() == 1.toByte())
            'R'.code.toByte() -> Refusal(peer, from.bytes(), from.text())
            'O'.code.toByte() -> Order(
                peer,
                from.getLong(),
                from.getLong(),
                from.getLong(),
                one(Phase.entries, from.get()),
                from.getInt(),
                from.text(),
                List(from.count(SHORTEST_PEER)) { from.peer() },
            )
            'S'.code.toByte() ->
                Standing(peer, from.getLong(), from.getLong(), one(State.entries, from.get()), from.text())
            'F'.code.toByte() -> Farewell(peer, from.getLong())
            else -> throw IllegalArgumentException("a note of the kind $kind")
        }
    }

    /** Bytes that [note] takes at most. */
    fun room(note: Note): Int = ROOM + if (note is Order) note.members.size * (SHORTEST_PEER + LONGEST_NAME) else 0

    private fun kindOf(note: Note): Byte = when (note) {
        is Hello -> 'H'
        is Challenge -> 'C'
        is Proof -> 'P'
        is Welcome -> 'W'
        is Refusal -> 'R'
        is Order -> 'O'
        is Standing -> 'S'
        is Farewell -> 'F'
    }.code.toByte()

    private fun ByteBuffer.peer(peer: Peer) =
        text(peer.address.host).putInt(peer.address.port).putLong(peer.incarnation)

    private fun ByteBuffer.peer(): Peer {
        val host = text(HostPort.HOST)
        val port = getInt()
        require(port in 1..HostPort.LAST_PORT) { "port $port" }
        return Peer(HostPort(host, port), getLong())
    }

    private fun ByteBuffer.bytes(bytes: ByteArray): ByteBuffer = putInt(bytes.size).put(bytes)

    private fun ByteBuffer.bytes() = ByteArray(count(1)).also(::get)

    /** At most [LONGEST_TEXT] bytes of it: the rest of a long message is of no use to who reads it. */
    private fun ByteBuffer.text(text: String): ByteBuffer {
        val bytes = text.toByteArray()
        return bytes(if (bytes.size <= LONGEST_TEXT) bytes else bytes.copyOf(LONGEST_TEXT))
    }

    private fun ByteBuffer.text(): String {
        val bytes = bytes()
        require(bytes.size <= LONGEST_TEXT) { "a text of ${bytes.size} bytes" }
        return String(bytes, Charsets.UTF_8)
    }

    private fun ByteBuffer.text(form: Regex): String =
        text().also { require(it.length <= LONGEST_NAME && form.matches(it)) { "a name of another form than $form" } }

    /** A number of things that take at least [size] bytes each and must be there. */
    private fun ByteBuffer.count(size: Int): Int {
        val count = getInt()
        require(count in 0..remaining() / size) { "$count things of $size bytes in ${remaining()} bytes" }
        return count
    }

    private fun <T> one(all: List<T>, index: Byte): T =
        requireNotNull(all.getOrNull(index.toInt())) { "number $index of $all" }

    private const val LONGEST_TEXT = 1000
    private const val LONGEST_NAME = 255
    private val VERSION = Regex("[A-Za-z0-9._+-]{1,64}")
    private const val SHORTEST_PEER = 16
    private const val ROOM = 4096
}
