package daphnis.core.format

import io.jhdf.exceptions.UnsupportedHdfException
import java.nio.file.Path

/**
 * Reads the states of an H5MD file, whichever program wrote it. Of several groups of particles `all` is read. Velocity,
 * id, mass and radius may be missing; the last three may be datasets or elements with a value per frame. Other programs
 * may have the box begin at the origin: then particles are moved by half a box.
 */
internal class H5mdReader(
    private val source: H5Source,
    private val path: Path,
    private val notices: MutableList<String>,
) {
    private val all = "particles/${group()}"
    private val times = H5mdTimes(source, all, path)

    /** Others do not write the offset of sliding images. */
    private val isOwn = source.has(OFFSET)

    private val materials =
        if (source.hasAttribute(PARAMETERS, H5md.MATERIALS)) source.texts(PARAMETERS, H5md.MATERIALS) else emptyList()

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
        val cells = H5mdBox(source, all, path, isOwn).cells(steps, periodic)
        val lean = if (isOwn) ownLean(count) else cells.map { Lean.of(it) }
        // HDF5 as it is written here has no datasets of size 0, so a state without particles has no values at all.
        val hasParticles = PARTS.any { source.has("$all/$it") }
        val particles = if (hasParticles) H5mdParticles(source, all, path, count, materials) else null
        for (part in source.names(all)) if (part in USED) times.requireSame(part, steps)
        val shifts = if (isOwn) null else particles?.centre(cells)
        val snapshots = steps.indices.map { t ->
            val head = H5mdParticles.Head(
                steps[t],
                time[t],
                times.areKnown,
                cells[t].lengths,
                periodic,
                lean[t],
                shifts?.get(t) ?: DoubleArray(3),
            )
            (particles?.state(t, head) ?: head.empty()).let { if (count == 1L) it.with(bound = bound()) else it }
        }
        val checksum = source.number(PARAMETERS, H5mdChecksum.ATTRIBUTE)
        if (checksum != null && snapshots.isNotEmpty() && checksum != H5mdChecksum.of(snapshots)) {
            throw FormatException("$path: is damaged: its checksum is wrong")
        }
        for ((t, snapshot) in snapshots.withIndex()) SnapshotCheck.check(snapshot, "$path: frame $t")
        for (name in source.names(all)) if (name !in USED) notices += "$path: $all/$name is not used"
        return snapshots
    }

    /** Pairs that are bound; null where the file does not say. */
    private fun bound(): IntArray? {
        val name = "${H5md.CONNECTIVITY}/${H5md.BOUND}"
        val count = source.number(PARAMETERS, H5md.BOUND)
        if (!isOwn || count == null) return null
        return if (count == 0L) IntArray(0) else source.ints(name, listOf(2 * count), 0..Int.MAX_VALUE)
    }

    /** How far images slid in a file of daphnis. */
    private fun ownLean(count: Long): List<Lean> {
        val offsets = source.doubles(OFFSET, listOf(count))
        val shear = "parameters/shear_axes"
        val axes = if (source.has(shear)) source.ints(shear, listOf(2L), 0..2) else intArrayOf(1, 0)
        if (axes[0] == axes[1]) fail("parameters/shear_axes are both ${axes[0]}")
        return offsets.map { Lean(it, axes[0], axes[1]) }
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
        private const val PARAMETERS = "parameters"
        private const val OFFSET = "$PARAMETERS/shear_offset"
        private val USED = NUMBERED.map { it.title }.toSet() + setOf("box", "image", "id", H5md.SPECIES)
        private val PARTS = listOf("id", "velocity", "position/value")

        /**
         * Every snapshot of [path].
         *
         * @param notices receives what is there and not used
         * @throws FormatException for every error of the library with a file that is damaged or not HDF5, in one line
         */
        fun read(path: Path, notices: MutableList<String>): List<Snapshot> = try {
            H5Source(path).use { H5mdReader(it, path, notices).snapshots() }
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
            val all = generateSequence(e) { it.cause }.take(MOST_LOOKED_AT)
            all.find { it is UnsupportedHdfException }?.let { return unsupported(path, it) }
            val causes = all.take(MOST_CAUSES)
            val words = causes.map {
                it.message.orEmpty().replace(CLASS, "").take(MOST_SHOWN)
            }.filter { it.isNotBlank() }
            val problem = words.distinct().joinToString(", for: ").ifEmpty { "it is cut short or damaged" }
            val kind = if (NO_HDF5 in problem) "HDF5 file" else "H5MD file of daphnis"
            return FormatException("$path: is not an $kind: $problem")
        }

        private fun unsupported(path: Path, e: Throwable): FormatException {
            val what = e.message.orEmpty().take(MOST_SHOWN)
            return FormatException("$path: is HDF5 of a kind that is not read: $what; $OLDER")
        }

        /** The way out for files of HDF5 2.0, whose chunks have a layout of version 5. */
        private const val OLDER = "write it for HDF5 1.14 or older, as by h5py.File(…, libver=('earliest', 'v114'))"

        /** The class with which some messages begin, which tells a user nothing. */
        private val CLASS = Regex("""[\w.$]*(Exception|Error)(: )?""")
        private const val MOST_SHOWN = 120

        /** What the library says of a file of another kind, or an empty one. */
        private const val NO_HDF5 = "No valid HDF5 signature"
        private const val MOST_CAUSES = 3
        private const val MOST_LOOKED_AT = 20
    }
}
