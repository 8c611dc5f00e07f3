package daphnis.core.run

import daphnis.core.OutputState
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.DataInputStream
import java.io.DataOutputStream
import java.io.IOException

/**
 * What outputs keep in a checkpoint, as bytes: the number of outputs; for each its name and number of arrays; for each
 * array its name, `D` for doubles or `L` for longs, its length, and the numbers. Names are written by
 * [DataOutputStream.writeUTF], counts as ints, all big-endian.
 */
internal object SavedOutputs {
    fun bytes(saved: Map<String, OutputState>): ByteArray {
        val bytes = ByteArrayOutputStream()
        DataOutputStream(bytes).use { out ->
            out.writeInt(saved.size)
            for ((name, state) in saved) {
                out.writeUTF(name)
                out.writeInt(state.names.size)
                for (array in state.names) write(out, array, state.array(array))
            }
        }
        return bytes.toByteArray()
    }

    private fun write(out: DataOutputStream, name: String, array: Any) {
        out.writeUTF(name)
        if (array is DoubleArray) {
            out.writeByte('D'.code)
            out.writeInt(array.size)
            for (value in array) out.writeDouble(value)
        } else {
            array as LongArray
            out.writeByte('L'.code)
            out.writeInt(array.size)
            for (value in array) out.writeLong(value)
        }
    }

    /** @throws IllegalArgumentException when [bytes] are not saved outputs */
    fun of(bytes: ByteArray): Map<String, OutputState> = try {
        val input = DataInputStream(ByteArrayInputStream(bytes))
        val saved = LinkedHashMap<String, OutputState>()
        repeat(input.readInt()) {
            val name = input.readUTF()
            val state = OutputState(name)
            repeat(input.readInt()) { read(input, state) }
            saved[name] = state
        }
        saved
    } catch (e: IOException) {
        throw IllegalArgumentException("saved outputs are cut short or damaged", e)
    }

    private fun read(input: DataInputStream, state: OutputState) {
        val name = input.readUTF()
        val kind = input.readByte().toInt().toChar()
        val size = input.readInt()
        require(size in 0..input.available() / Long.SIZE_BYTES) { "an array of an output says it has $size numbers" }
        when (kind) {
            'D' -> state.put(name, DoubleArray(size) { input.readDouble() })
            'L' -> state.put(name, LongArray(size) { input.readLong() })
            else -> throw IllegalArgumentException("an array of an output is of kind '$kind'")
        }
    }
}
