package daphnis.core.format.hdf5

/**
 * The messages of which headers of groups and datasets are made, and how they are laid out: chapter IV.A of the *HDF5
 * File Format Specification*, version 3.0. Here are only those that daphnis writes.
 */
internal object Messages {
    /** The address of what is not there, and the extent of what may grow without end. */
    const val NONE = -1L

    private const val DATASPACE = 0x01
    private const val LINK_INFO = 0x02
    private const val DATATYPE = 0x03
    private const val FILL_VALUE = 0x05
    private const val LINK = 0x06
    private const val LAYOUT = 0x08
    private const val GROUP_INFO = 0x0A
    private const val FILTERS = 0x0B
    private const val ATTRIBUTE = 0x0C
    private const val BTREE_K = 0x13
    private const val ATTRIBUTE_INFO = 0x15
    private const val REFERENCES = 0x16

    private const val MOST_BYTES = 0xffff
    private const val SHUFFLE = 2
    private const val DEFLATE = 1

    /** A header of version 2 of [messages], with its checksum. */
    fun header(messages: List<Message>): ByteArray {
        val size = messages.sumOf { PREFIX + it.body.size }
        // Flag 2: the size that follows has four bytes.
        val bytes = Bytes(size + 16).text("OHDR").byte(2).byte(2).int(size)
        for (message in messages) bytes.byte(message.type).short(message.body.size).byte(0).all(message.body)
        return bytes.checksum().array()
    }

    private const val PREFIX = 4

    class Message(val type: Int, bytes: Bytes) {
        val body: ByteArray = bytes.array()

        init {
            require(body.size <= MOST_BYTES) { "${body.size} bytes are too many for a message of a header of HDF5" }
        }
    }

    /** The messages of a group whose [links] are in its header: names with addresses. */
    fun group(links: Map<String, Long>): List<Message> = listOf(
        Message(LINK_INFO, Bytes().byte(0).byte(0).long(NONE).long(NONE)),
        Message(GROUP_INFO, Bytes().byte(0).byte(0)),
    ) + links.map { (name, address) ->
        val text = name.toByteArray()
        // Flags 0: a hard link, whose name in ASCII has a length of one byte.
        Message(LINK, Bytes().byte(1).byte(0).byte(text.size).all(text).long(address))
    }

    fun attribute(name: String, type: Datatype, extents: LongArray, data: ByteArray): Message {
        val text = name.toByteArray()
        val space = space(extents, extents)
        return Message(
            ATTRIBUTE,
            Bytes().byte(3).byte(0).short(text.size + 1).short(type.description.size).short(space.size).byte(0)
                .all(text).byte(0).all(type.description).all(space).all(data),
        )
    }

    /** That there are attributes in the header: without it the HDF5 library counts none. */
    fun attributeInfo(): Message = Message(ATTRIBUTE_INFO, Bytes().byte(0).byte(0).long(NONE).long(NONE))

    /** @param grows whether the first extent may grow without end */
    fun dataspace(extents: LongArray, grows: Boolean): Message {
        val most = if (grows) extents.copyOf().also { it[0] = NONE } else extents
        return Message(DATASPACE, space(extents, most))
    }

    private fun space(extents: LongArray, most: LongArray): Bytes {
        val hasMost = !extents.contentEquals(most)
        val bytes = Bytes().byte(2).byte(extents.size).byte(if (hasMost) 1 else 0).byte(if (extents.isEmpty()) 0 else 1)
        for (extent in extents) bytes.long(extent)
        if (hasMost) for (extent in most) bytes.long(extent)
        return bytes
    }

    fun datatype(type: Datatype): Message = Message(DATATYPE, Bytes().all(type.description))

    /** No fill value, so zeros; where [grows], space is taken as it is needed. */
    fun fillValue(grows: Boolean): Message = Message(FILL_VALUE, Bytes().byte(3).byte(if (grows) 0x0B else 0x0A))

    fun contiguous(address: Long, size: Long): Message =
        Message(LAYOUT, Bytes().byte(3).byte(1).long(address).long(size))

    /** @param index address of the root of the [ChunkIndex] */
    fun chunked(index: Long, chunk: IntArray, type: Datatype): Message {
        val bytes = Bytes().byte(3).byte(2).byte(chunk.size + 1).long(index)
        for (extent in chunk) bytes.int(extent)
        return Message(LAYOUT, bytes.int(type.size))
    }

    /** Shuffle, then deflate. */
    fun filters(type: Datatype, level: Int): Message {
        val bytes = Bytes().byte(2).byte(2)
        for ((filter, value) in listOf(SHUFFLE to type.size, DEFLATE to level)) {
            // Flag 1: a chunk may be without it.
            bytes.short(filter).short(1).short(1).int(value)
        }
        return Message(FILTERS, bytes)
    }

    /** How many links lead to the object. */
    fun references(count: Int): Message = Message(REFERENCES, Bytes().byte(0).int(count))

    /** Half the number of children of a node of a [ChunkIndex]; the other two, of old groups, are the usual ones. */
    fun halfFanout(half: Int): Message = Message(BTREE_K, Bytes().byte(0).short(half).short(16).short(4))
}
