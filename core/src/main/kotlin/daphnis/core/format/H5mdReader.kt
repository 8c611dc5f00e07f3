package daphnis.core.format

import java.nio.file.Path

/** Reads the states of an H5MD file of the layout that [H5md] writes, whoever wrote it. */
internal class H5mdReader(private val source: H5Source, private val path: Path) {
    private fun frames(): List<Frame> {
        val steps = source.longs("$ALL/position/step", one("$ALL/position/step"))
        val count = steps.size.toLong()
        val times = source.doubles("$ALL/position/time", listOf(count))
        val periodic = periodic()
        val offsets = source.doubles("parameters/shear_offset", listOf(count))
        val axes = if (source.has("parameters/shear_axes")) source.ints("parameters/shear_axes", listOf(2L), 0..2) else intArrayOf(1, 0)
        if (axes[0] == axes[1]) fail("parameters/shear_axes are both ${axes[0]}")
        val lengths = lengths(steps.size)
        // HDF5 as it is written here has no datasets of size 0: a state without particles has no values at all.
        val particles = if (source.has("$ALL/id") || source.has("$ALL/velocity")) Particles(count) else null
        return steps.indices.map { t ->
            Frame(
                steps[t], times[t], lengths[t], periodic, offsets[t], particles?.id ?: IntArray(0),
                particles?.columns(particles.position, t) ?: none(), particles?.columns(particles.velocity, t) ?: none(),
                particles?.radius ?: DoubleArray(0), particles?.mass ?: DoubleArray(0), axes[0], axes[1], image = particles?.image(t),
            ).also { FrameCheck.check(it, "$path: frame $t") }
        }
    }

    private fun none() = Array(3) { DoubleArray(0) }

    /** The shape of [name], which must have one axis. */
    private fun one(name: String): List<Long> = source.shape(name).also { if (it.size != 1) fail("$name has ${it.size} axes; it must have 1, one number per frame") }

    private fun periodic(): BooleanArray {
        val words = source.texts("$ALL/box", "boundary")
        if (words.size != 3 || words.any { it != "periodic" && it != "none" }) fail("$ALL/box: boundary must be three times 'periodic' or 'none'")
        return BooleanArray(3) { words[it] == "periodic" }
    }

    /** Of a row of lengths, or of edge vectors by row, per frame. */
    private fun lengths(frames: Int): List<DoubleArray> {
        if (!source.has("$ALL/box/edges")) return List(frames) { DoubleArray(3) { Double.NaN } }
        val name = "$ALL/box/edges/value"
        val isMatrix = source.shape(name).size == 3
        val data = source.doubles(name, if (isMatrix) listOf(frames.toLong(), 3, 3) else listOf(frames.toLong(), 3))
        return List(frames) { t -> DoubleArray(3) { if (isMatrix) data[9 * t + 4 * it] else data[3 * t + it] } }
    }

    /** What the file holds of the particles, all frames. */
    private inner class Particles(frames: Long) {
        private val count: Long = source.shape("$ALL/position/value").let { shape ->
            if (shape.size != 3 || shape[0] != frames || shape[2] != 3L) fail("$ALL/position/value has the shape $shape; it must be [$frames, particles, 3]")
            shape[1]
        }
        private val cube = listOf(frames, count, 3L)
        val id = source.ints("$ALL/id", listOf(count), 0 until ParticleCsv.MOST_ID)
        val mass = source.doubles("$ALL/mass", listOf(count))
        val radius = source.doubles("$ALL/radius", listOf(count))
        val position = source.doubles("$ALL/position/value", cube)
        val velocity = source.doubles("$ALL/velocity/value", cube)
        private val images = if (source.has("$ALL/image")) source.ints("$ALL/image/value", cube, Int.MIN_VALUE..Int.MAX_VALUE) else null

        fun columns(values: DoubleArray, t: Int): Array<DoubleArray> = Array(3) { axis -> DoubleArray(id.size) { values[3 * (t * id.size + it) + axis] } }

        fun image(t: Int): Array<IntArray>? = images?.let { all -> Array(3) { axis -> IntArray(id.size) { all[3 * (t * id.size + it) + axis] } } }
    }

    private fun fail(problem: String): Nothing = throw FormatException("$path: $problem")

    companion object {
        private const val ALL = "particles/all"

        /**
         * Every frame of [path].
         *
         * @throws FormatException for whatever the library makes of a file that is none or damaged, in one line
         */
        fun read(path: Path): List<Frame> = try {
            H5Source(path).use { H5mdReader(it, path).frames() }
        } catch (e: FormatException) {
            throw e
        } catch (e: RuntimeException) {
            throw none(path, e)
        } catch (e: StackOverflowError) {
            throw none(path, e)
        } catch (e: OutOfMemoryError) {
            throw FormatException("$path: asks for more memory than the JVM has, ${Runtime.getRuntime().maxMemory() shr 20} MiB; raise it with -Xmx if the file is sound")
        } catch (e: LinkageError) {
            // Of a filter that is not installed.
            throw none(path, e)
        }

        private fun none(path: Path, e: Throwable): FormatException {
            val causes = generateSequence(e) { it.cause }.take(MOST_CAUSES).map { it.message.orEmpty().replace(CLASS, "").take(MOST_SHOWN) }
            val problem = causes.filter { it.isNotBlank() }.distinct().joinToString(", for: ").ifEmpty { "it is cut short or damaged" }
            return FormatException("$path: is not an H5MD file of daphnis: $problem")
        }

        /** The class that some messages begin with, which says nothing to a user. */
        private val CLASS = Regex("""[\w.$]*(Exception|Error)(: )?""")
        private const val MOST_SHOWN = 120
        private const val MOST_CAUSES = 3
    }
}
