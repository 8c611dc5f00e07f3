package daphnis.core.format

import java.nio.file.Path

/** Reads the states of an H5MD file with the layout that [H5md] writes, whichever program wrote it. */
internal class H5mdReader(private val source: H5Source, private val path: Path) {
    private fun snapshots(): List<Snapshot> {
        val steps = source.longs("$ALL/position/step", one("$ALL/position/step"))
        val count = steps.size.toLong()
        val times = source.doubles("$ALL/position/time", listOf(count))
        val periodic = periodic()
        val offsets = source.doubles("parameters/shear_offset", listOf(count))
        val shear = "parameters/shear_axes"
        val axes = if (source.has(shear)) source.ints(shear, listOf(2L), 0..2) else intArrayOf(1, 0)
        if (axes[0] == axes[1]) fail("parameters/shear_axes are both ${axes[0]}")
        val lengths = lengths(steps.size)
        // HDF5 as it is written here has no datasets of size 0, so a state without particles has no values at all.
        val particles = if (source.has("$ALL/id") || source.has("$ALL/velocity")) Particles(count) else null
        val snapshots = steps.indices.map { t ->
            Snapshot(
                steps[t], times[t], lengths[t], periodic, offsets[t], particles?.id ?: IntArray(0),
                columns(particles?.position, t), columns(particles?.velocity, t),
                particles?.radius ?: DoubleArray(0), particles?.mass ?: DoubleArray(0),
                axes[0], axes[1], image = particles?.images?.image(t),
            )
        }
        val checksum = source.number("parameters", H5mdChecksum.ATTRIBUTE)
        if (checksum != null && snapshots.isNotEmpty() && checksum != H5mdChecksum.of(snapshots)) {
            throw FormatException("$path: is damaged: its checksum is wrong")
        }
        for ((t, snapshot) in snapshots.withIndex()) SnapshotCheck.check(snapshot, "$path: frame $t")
        return snapshots
    }

    /** Of frame [t], by axis. */
    private fun columns(values: Cube<DoubleArray>?, t: Int): Array<DoubleArray> {
        if (values == null) return Array(3) { DoubleArray(0) }
        return Array(3) { axis -> DoubleArray(values.count) { values.data[values.at(t, it, axis)] } }
    }

    private fun Cube<IntArray>.image(t: Int): Array<IntArray> = Array(3) { axis ->
        IntArray(count) { data[at(t, it, axis)] }
    }

    /** Numbers by frame, particle and axis, the axis fastest. */
    private class Cube<A>(val data: A, val count: Int) {
        fun at(t: Int, k: Int, axis: Int): Int = 3 * (t * count + k) + axis
    }

    /** The shape of [name], which must have one axis. */
    private fun one(name: String): List<Long> {
        val shape = source.shape(name)
        if (shape.size != 1) fail("$name has ${shape.size} axes; it must have 1, one number per frame")
        return shape
    }

    private fun periodic(): BooleanArray {
        val words = source.texts("$ALL/box", "boundary")
        if (words.size != 3 || words.any { it != "periodic" && it != "none" }) {
            fail("$ALL/box: boundary must be three times 'periodic' or 'none'")
        }
        return BooleanArray(3) { words[it] == "periodic" }
    }

    /** Of a row of lengths, or of edge vectors by row, per frame. */
    private fun lengths(count: Int): List<DoubleArray> {
        if (!source.has("$ALL/box/edges")) return List(count) { DoubleArray(3) { Double.NaN } }
        val name = "$ALL/box/edges/value"
        val isMatrix = source.shape(name).size == 3
        val data = source.doubles(name, if (isMatrix) listOf(count.toLong(), 3, 3) else listOf(count.toLong(), 3))
        return List(count) { t -> DoubleArray(3) { if (isMatrix) data[9 * t + 4 * it] else data[3 * t + it] } }
    }

    /** The data of the particles in the file, for all frames. */
    private inner class Particles(frames: Long) {
        private val count: Long = source.shape("$ALL/position/value").let { shape ->
            if (shape.size != 3 || shape[0] != frames || shape[2] != 3L) {
                fail("$ALL/position/value has the shape $shape; it must be [$frames, particles, 3]")
            }
            shape[1]
        }
        private val shape = listOf(frames, count, 3L)
        val id = source.ints("$ALL/id", listOf(count), 0..Int.MAX_VALUE)
        val mass = source.doubles("$ALL/mass", listOf(count))
        val radius = source.doubles("$ALL/radius", listOf(count))
        val position = Cube(source.doubles("$ALL/position/value", shape), id.size)
        val velocity = Cube(source.doubles("$ALL/velocity/value", shape), id.size)
        val images = if (source.has("$ALL/image")) Cube(source.ints("$ALL/image/value", shape, ANY), id.size) else null
    }

    private fun fail(problem: String): Nothing = throw FormatException("$path: $problem")

    companion object {
        private const val ALL = "particles/all"
        private val ANY = Int.MIN_VALUE..Int.MAX_VALUE

        /**
         * Every snapshot of [path].
         *
         * @throws FormatException for every error of the library with a file that is damaged or not HDF5, in one line
         */
        fun read(path: Path): List<Snapshot> = try {
            H5Source(path).use { H5mdReader(it, path).snapshots() }
        } catch (e: FormatException) {
            throw e
        } catch (e: RuntimeException) {
            throw none(path, e)
        } catch (e: StackOverflowError) {
            throw none(path, e)
        } catch (e: OutOfMemoryError) {
            throw FormatException(
                "$path: asks for more memory than the JVM has, ${Runtime.getRuntime().maxMemory() shr 20} MiB; " +
                    "raise it with -Xmx if the file is sound",
            )
        } catch (e: LinkageError) {
            throw FormatException("$path: is compressed by a library that is not on the class path: ${e.message}")
        }

        private fun none(path: Path, e: Throwable): FormatException {
            val causes = generateSequence(e) { it.cause }.take(MOST_CAUSES)
            val words = causes.map {
                it.message.orEmpty().replace(CLASS, "").take(MOST_SHOWN)
            }.filter { it.isNotBlank() }
            val problem = words.distinct().joinToString(", for: ").ifEmpty { "it is cut short or damaged" }
            return FormatException("$path: is not an H5MD file of daphnis: $problem")
        }

        /** The class with which some messages begin, which tells a user nothing. */
        private val CLASS = Regex("""[\w.$]*(Exception|Error)(: )?""")
        private const val MOST_SHOWN = 120
        private const val MOST_CAUSES = 3
    }
}
