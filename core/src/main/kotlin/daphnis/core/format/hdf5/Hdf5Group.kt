package daphnis.core.format.hdf5

import daphnis.core.format.hdf5.Messages.Message
import java.io.IOException

/** What a file names: a group or a dataset, with attributes. */
internal abstract class Hdf5Object(protected val file: Hdf5File) {
    private val attributes = ArrayList<Message>()

    /** Number of names in groups that lead to it. */
    var links = 0
    private var address = Messages.NONE

    fun attribute(name: String, vararg values: Int) {
        val data = Bytes()
        for (value in values) data.int(value)
        put(name, Datatype.INT, values.size, data)
    }

    fun attribute(name: String, value: Long): Unit = put(name, Datatype.LONG, 1, Bytes().long(value))

    fun attribute(name: String, value: String): Unit = texts(name, listOf(value), LongArray(0))

    fun attribute(name: String, values: List<String>): Unit = texts(name, values, longArrayOf(values.size.toLong()))

    private fun texts(name: String, values: List<String>, extents: LongArray) {
        val type = Datatype.text(values.maxOf { it.toByteArray().size })
        val data = Bytes()
        for ((k, value) in values.withIndex()) data.text(value).zerosTo((k + 1) * type.size)
        attributes += Messages.attribute(name, type, extents, data.array())
    }

    /** One number has no axis. */
    private fun put(name: String, type: Datatype, count: Int, data: Bytes) {
        val extents = if (count == 1) LongArray(0) else longArrayOf(count.toLong())
        attributes += Messages.attribute(name, type, extents, data.array())
    }

    /** Writes data that are held back. */
    open fun finish() = Unit

    /** Chunks of the dataset, or of that of the group that has most. */
    open fun mostChunks(): Int = 0

    protected abstract fun messages(index: ChunkIndex): List<Message>

    /** Writes what is below it and its header, once, and returns the address of the header. */
    @Throws(IOException::class)
    fun write(index: ChunkIndex): Long {
        if (address == Messages.NONE) {
            val counted = if (links > 1) listOf(Messages.references(links)) else emptyList()
            val named = if (attributes.isEmpty()) emptyList() else listOf(Messages.attributeInfo()) + attributes
            address = file.append(Messages.header(messages(index) + named + counted))
        }
        return address
    }
}

/** A group: names of datasets and groups. Names are ASCII. */
internal class Hdf5Group(file: Hdf5File) : Hdf5Object(file) {
    private val members = LinkedHashMap<String, Hdf5Object>()

    /** A new group [name] in it. */
    fun group(name: String): Hdf5Group = Hdf5Group(file).also { put(name, it) }

    /** Lets [name] lead to [member], which may have other names. */
    fun put(name: String, member: Hdf5Object) {
        require(members.put(name, member) == null) { "there is a member $name" }
        member.links++
    }

    /** A new dataset [name] of one axis with these numbers, all of which are written now. */
    @Throws(IOException::class)
    fun dataset(name: String, values: DoubleArray): Hdf5Object =
        FixedDataset(file, Datatype.DOUBLE, values.size) { values[it].toRawBits() }.also { put(name, it) }

    /** The same for integers of 32 bits. */
    @Throws(IOException::class)
    fun dataset(name: String, values: IntArray): Hdf5Object =
        FixedDataset(file, Datatype.INT, values.size) { values[it].toLong() }.also { put(name, it) }

    override fun finish() {
        for (member in members.values) member.finish()
    }

    override fun mostChunks(): Int = members.values.maxOfOrNull { it.mostChunks() } ?: 0

    override fun messages(index: ChunkIndex): List<Message> = Messages.group(
        members.mapValues {
            it.value.write(index)
        },
    )
}

/** A dataset of one axis that is written at once, as it is. */
private class FixedDataset(file: Hdf5File, private val type: Datatype, private val count: Int, bits: (Int) -> Long) :
    Hdf5Object(file) {
    private val data: Long

    init {
        data = file.position
        var from = 0
        while (from < count) {
            val until = minOf(from + BLOCK, count)
            val bytes = Bytes(type.size * (until - from))
            for (k in from until until) bytes.number(bits(k), type.size)
            file.append(bytes.array())
            from = until
        }
    }

    override fun messages(index: ChunkIndex): List<Message> = listOf(
        Messages.dataspace(longArrayOf(count.toLong()), grows = false),
        Messages.datatype(type),
        Messages.fillValue(grows = false),
        Messages.contiguous(data, count.toLong() * type.size),
    )

    private companion object {
        const val BLOCK = 8192
    }
}
