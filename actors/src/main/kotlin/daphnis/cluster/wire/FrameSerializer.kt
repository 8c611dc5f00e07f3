package daphnis.cluster.wire

import daphnis.cluster.link.LinkMessage
import org.apache.pekko.serialization.ByteBufferSerializer
import org.apache.pekko.serialization.SerializerWithStringManifest
import java.io.NotSerializableException
import java.nio.BufferUnderflowException
import java.nio.ByteBuffer

/** All that daphnis sends between processes, for Pekko: [LinkCodec] and [NoteCodec]. Named in cluster.conf. */
internal class FrameSerializer :
    SerializerWithStringManifest(),
    ByteBufferSerializer {
    override fun identifier(): Int = IDENTIFIER

    override fun manifest(message: Any): String = when (message) {
        is LinkMessage -> LINK
        is Note -> NOTE
        else -> throw NotSerializableException(message.javaClass.name)
    }

    override fun toBinary(message: Any, buffer: ByteBuffer) {
        when (message) {
            is LinkMessage -> LinkCodec.write(message, buffer)
            is Note -> NoteCodec.write(message, buffer)
            else -> throw NotSerializableException(message.javaClass.name)
        }
    }

    override fun fromBinary(buffer: ByteBuffer, manifest: String): Any = try {
        when (manifest) {
            LINK -> LinkCodec.read(buffer)
            NOTE -> NoteCodec.read(buffer)
            else -> throw NotSerializableException("a frame of the kind '$manifest'")
        }
    } catch (e: IllegalArgumentException) {
        throw NotSerializableException("a damaged frame: ${e.message}")
    } catch (_: BufferUnderflowException) {
        throw NotSerializableException("a frame that is cut short")
    }

    override fun toBinary(message: Any): ByteArray {
        val room = when (message) {
            is LinkMessage -> LinkCodec.room(message)
            is Note -> NoteCodec.room(message)
            else -> throw NotSerializableException(message.javaClass.name)
        }
        val buffer = ByteBuffer.allocate(room)
        toBinary(message, buffer)
        return buffer.array().copyOf(buffer.position())
    }

    override fun fromBinary(bytes: ByteArray, manifest: String): Any = fromBinary(ByteBuffer.wrap(bytes), manifest)

    private companion object {
        /** Unlike that of any other serializer of the system; those below 40 are Pekko's. */
        const val IDENTIFIER = 7_219_044
        const val LINK = "L"
        const val NOTE = "N"
    }
}
