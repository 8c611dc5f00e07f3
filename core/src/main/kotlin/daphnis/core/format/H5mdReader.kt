package daphnis.core.format

import java.nio.file.Path

/**
 * Reads the states of an H5MD file, whichever program wrote it. Of several groups of particles `all` is read. Velocity,
 * id, mass and radius may be missing; the last three may be datasets or elements with a value per frame. Other programs
 * may have the box begin at the origin: then particles are moved by half a box.
 */
internal class H5mdReader(private val source: H5Source, private val path: Path) {
    private val all = "particles/${group()}"
    private val times = H5mdTimes(source, all, path)

    /** Others do not write the offset of sliding images. */
    private val isOwn = source.has(OFFSET)

    private fun group(): String {
        val names = source.names("particles")
        if (names.isEmpty() || "all" in names) return "all"
        return names.singleOrNull()
            ?: fail("has groups of particles ${names.joinToString()}; one of them must be 'all'")
    }

    private fun snapshots(): List<Snapshot> {
        val steps = times.steps()
        val count = steps.size.toLong()
        val time = times.times(steps)
        val periodic = periodic()
        val offsets = if (isOwn) source.doubles(OFFSET, listOf(count)) else DoubleArray(steps.size)
        val shear = "parameters/shear_axes"
        val axes = if (source.has(shear)) source.ints(shear, listOf(2L), 0..2) else intArrayOf(1, 0)
        if (axes[0] == axes[1]) fail("parameters/shear_axes are both ${axes[0]}")
        val lengths = H5mdBox(source, all, path, isOwn).lengths(steps.size)
        // HDF5 as it is written here has no datasets of size 0, so a state without particles has no values at all.
        val hasParticles = PARTS.any { source.has("$all/$it") }
        val particles = if (hasParticles) H5mdParticles(source, all, path, count) else null
        if (!isOwn) particles?.centre(periodic, lengths)
        val snapshots = steps.indices.map { t ->
            particles?.state(t, steps[t], time[t], lengths[t], periodic, offsets[t], axes) ?: Snapshot(
                steps[t], time[t], lengths[t], periodic, offsets[t], IntArray(0), Array(3) { DoubleArray(0) },
                Array(3) { DoubleArray(0) }, DoubleArray(0), DoubleArray(0), axes[0], axes[1],
            )
        }
        val checksum = source.number("parameters", H5mdChecksum.ATTRIBUTE)
        if (checksum != null && snapshots.isNotEmpty() && checksum != H5mdChecksum.of(snapshots)) {
            throw FormatException("$path: is damaged: its checksum is wrong")
        }
        for ((t, snapshot) in snapshots.withIndex()) SnapshotCheck.check(snapshot, "$path: frame $t")
        return snapshots
    }

    private fun periodic(): BooleanArray {
        val words = source.texts("$all/box", "boundary")
        if (words.size != 3 || words.any { it != "periodic" && it != "none" }) {
            fail("$all/box: boundary must be three times 'periodic' or 'none'")
        }
        return BooleanArray(3) { words[it] == "periodic" }
    }

    private fun fail(problem: String): Nothing = throw FormatException("$path: $problem")

    companion object {
        private const val OFFSET = "parameters/shear_offset"
        private val PARTS = listOf("id", "velocity", "position/value")

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
