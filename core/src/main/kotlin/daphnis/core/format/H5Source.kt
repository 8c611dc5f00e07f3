package daphnis.core.format

import io.jhdf.HdfFile
import io.jhdf.api.Dataset
import io.jhdf.api.Group
import io.jhdf.api.Node
import io.jhdf.api.dataset.ChunkedDataset
import io.jhdf.api.dataset.ContiguousDataset
import io.jhdf.links.ExternalLink
import io.jhdf.links.SoftLink
import io.jhdf.`object`.datatype.FixedPoint
import io.jhdf.`object`.datatype.FloatingPoint
import java.io.File
import java.math.BigInteger
import java.nio.file.Files
import java.nio.file.Path

/**
 * An HDF5 file with any content, as far as states are read from it: numbers of a known shape. The library follows links
 * wherever they lead and takes the memory that a file asks for. Here links are followed only a few times and never
 * leave the file. What a dataset declares is compared with the file's length and the heap before it is read. Whatever
 * its type of numbers, it is returned as doubles or longs.
 */
internal class H5Source(private val path: Path) : AutoCloseable {
    private val held: ByteArray? = when {
        PackedFile.isPacked(path) -> PackedFile.bytes(path, most())
        !canBeMapped(path) && Files.size(path) <= most() -> Files.readAllBytes(path)
        else -> null
    }
    private val file: HdfFile = if (held == null) HdfFile(path) else HdfFile.fromBytes(held)
    private val bytes: Double = (held?.size?.toLong() ?: Files.size(path)).toDouble()

    /** The library maps files. Windows lets nobody delete or replace one until the collector has seen to it. */
    private fun canBeMapped(path: Path) = isOnDisk(path) && File.separatorChar == '/'

    /** As much as may be held in memory beside what is read from it. */
    private fun most() = minOf(Runtime.getRuntime().maxMemory() / 2, Int.MAX_VALUE - 8L).toInt()

    /** Whether there is an object with the path [name], from the root, with `/` between. */
    fun has(name: String): Boolean = find(name) != null

    /**
     * Extents of the dataset [name], slowest first.
     *
     * @throws FormatException when there is none
     */
    fun shape(name: String): List<Long> = dataset(name).dimensionsAsLong.toList()

    /** The numbers of the dataset [name], the last index fastest, which must have the [shape]. */
    fun doubles(name: String, shape: List<Long>): DoubleArray = when (val data = numbers(name, shape)) {
        is DoubleArray -> data
        is FloatArray -> DoubleArray(data.size) { data[it].toDouble() }
        is LongArray -> DoubleArray(data.size) { data[it].toDouble() }
        is IntArray -> DoubleArray(data.size) { data[it].toDouble() }
        is Number -> doubleArrayOf(data.toDouble())
        else -> wrongType(name)
    }

    /** As [doubles], for whole numbers of at most 64 bits. */
    fun longs(name: String, shape: List<Long>): LongArray = when (val data = numbers(name, shape)) {
        is LongArray -> data
        is IntArray -> LongArray(data.size) { data[it].toLong() }
        is ShortArray -> LongArray(data.size) { data[it].toLong() }
        is ByteArray -> LongArray(data.size) { data[it].toLong() }
        is Long, is Int -> longArrayOf((data as Number).toLong())
        is Array<*> -> LongArray(data.size) { k ->
            (data[k] as? BigInteger)?.takeIf { it.bitLength() < Long.SIZE_BITS }?.toLong()
                ?: fail(name, "has ${data[k]}; it must be below 2^63")
        }
        else -> wrongType(name)
    }

    /** As [longs], within [range]. */
    fun ints(name: String, shape: List<Long>, range: IntRange): IntArray {
        val data = longs(name, shape)
        return IntArray(data.size) { k ->
            val value = data[k]
            if (value < range.first || value > range.last) {
                fail(name, "has $value; it must be in ${range.first}..${range.last}")
            }
            value.toInt()
        }
    }

    /** The strings of attribute [attribute] of the group [name]. */
    fun texts(name: String, attribute: String): List<String> {
        val data = (find(name) ?: fail(name, "is missing")).getAttribute(attribute)?.data
        return (data as? Array<*>)?.map { it as? String ?: fail(name, "attribute $attribute must be strings") }
            ?: fail(name, "has no list of texts $attribute")
    }

    /** Whether the group [name] has the attribute [attribute]. */
    fun hasAttribute(name: String, attribute: String): Boolean = find(name)?.getAttribute(attribute) != null

    /** Refuses the dataset [name] if it declares more than the file can hold or the heap can take. */
    fun requireSize(name: String): Unit = checkSize(name, dataset(name))

    /** Names of the objects in the group [name]; none when it is no group. */
    fun names(name: String): List<String> = (find(name) as? Group)?.children?.keys?.sorted().orEmpty()

    /** Whether [name] is a dataset of one number, without extents. */
    fun isScalar(name: String): Boolean = (find(name) as? Dataset)?.dimensionsAsLong?.isEmpty() == true

    /** The steps of [count] frames in the dataset [name]: listed, or in fixed intervals. */
    fun steps(name: String, count: Int): LongArray {
        if (!isScalar(name)) return longs(name, listOf(count.toLong()))
        val interval = longs(name, emptyList())[0]
        val offset = offset(name, "offset").toLong()
        return LongArray(count) { offset + it * interval }
    }

    /** The number in attribute [attribute] of [name], of any type; 0 when it has none. */
    fun offset(name: String, attribute: String): Double =
        (find(name)?.getAttribute(attribute)?.data as? Number)?.toDouble() ?: 0.0

    /** The numeric attribute [attribute] of the group [name]; null when it has none of that name. */
    fun number(name: String, attribute: String): Long? {
        val held = find(name)?.getAttribute(attribute) ?: return null
        return held.data as? Long ?: fail(name, "attribute $attribute must be a 64-bit integer")
    }

    private fun numbers(name: String, shape: List<Long>): Any {
        val dataset = dataset(name)
        val found = shape(name)
        if (found != shape) fail(name, "has the shape $found; it must be $shape")
        val type = dataset.dataType
        if (type !is FixedPoint && type !is FloatingPoint) wrongType(name)
        checkSize(name, dataset)
        if (shape.any { it == 0L }) return if (type is FixedPoint) LongArray(0) else DoubleArray(0)
        if (dataset.isEmpty) fail(name, "holds none of the numbers it declares")
        return (dataset as? ChunkedDataset)?.let { MaskedChunks.numbers(it) } ?: dataset.dataFlat
    }

    /** Called before anything is read. */
    private fun checkSize(name: String, dataset: Dataset) {
        val wide = dataset.dataType.size.toDouble()
        val declared = product(dataset.dimensionsAsLong) * wide
        val most = bytes * if (dataset is ContiguousDataset) 1.0 else DENSEST
        if (declared > most) fail(name, "declares $declared bytes; a file of $bytes bytes cannot hold so many")
        val heap = Runtime.getRuntime().maxMemory()
        if (declared * COPIES > heap) {
            fail(
                name,
                "declares $declared bytes, for which the ${heap shr MEBI} MiB of the JVM are too few; " +
                    "raise them with -Xmx",
            )
        }
        if (dataset !is ChunkedDataset) return
        val chunk = product(LongArray(dataset.chunkDimensions.size) { dataset.chunkDimensions[it].toLong() }) * wide
        if (!(chunk > 0 && chunk <= most && chunk * COPIES <= heap)) fail(name, "declares chunks of $chunk bytes")
    }

    private fun product(extents: LongArray): Double = extents.fold(1.0) { all, extent -> all * extent }

    private fun dataset(name: String): Dataset {
        val node = find(name) ?: fail(name, "is missing")
        return node as? Dataset ?: fail(name, "is a group; it must be a dataset, the same particles in every frame")
    }

    /** The object at [name], with links followed; null when there is none. */
    private fun find(name: String): Node? {
        var left = name.split('/').filter { it.isNotEmpty() }
        var node: Node = file
        var links = 0
        while (left.isNotEmpty()) {
            val group = node as? Group ?: return null
            val child = group.children[left[0]] ?: return null
            left = left.drop(1)
            if (child is ExternalLink) fail(name, "is a link to another file, which is not followed")
            if (child is SoftLink) {
                if (++links > MOST_LINKS) fail(name, "is a link to links without end")
                val target = child.targetPath
                if (target.startsWith('/')) node = file
                left = target.split('/').filter { it.isNotEmpty() && it != "." } + left
            } else {
                node = child
            }
        }
        return node
    }

    private fun wrongType(name: String): Nothing = fail(name, "has the wrong numeric type (at most 64 bits)")

    private fun fail(name: String, problem: String): Nothing = throw FormatException("$path: $name $problem")

    override fun close() {
        file.close()
    }

    private companion object {
        const val MOST_LINKS = 16

        /**
         * The most bytes from one byte of a compressed file: the bound of deflate, with a margin for the rest of the
         * file.
         */
        const val DENSEST = 1100.0

        /** How many times a dataset is in memory while it is read: its bytes, its numbers, and these by column. */
        const val COPIES = 3.0
        const val MEBI = 20
    }
}
