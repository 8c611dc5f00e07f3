package daphnis.core.run

import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path

/**
 * Compares the files to which a run appends with what a checkpoint knows of them.
 *
 * @property problems one line for each file that does not hold what the run wrote, with its name
 * @property beginnings of the files that do, to continue from
 */
internal class AppendedCheck(private val directory: RunDirectory, private val meta: CheckpointMeta) {
    val problems = ArrayList<String>()
    val beginnings = HashMap<String, Beginning>()

    init {
        for ((name, mark) in meta.appended) {
            val path = directory.path.resolve(name)
            mark.problem(path) { beginnings[name] = it }?.let { problems += "$path: $it" }
        }
    }

    /**
     * Accepts the files that have [problems] as they are, cut back to whole lines.
     *
     * @return one line for each, with its name and what is lost
     * @throws InputException when one cannot be read
     */
    fun acceptLoss(): List<String> = meta.appended.filterKeys { it !in beginnings }.map { (name, mark) ->
        val path = directory.path.resolve(name)
        try {
            accept(name, path, mark)
        } catch (e: IOException) {
            throw InputException(path.toString(), null, "cannot be read: ${reasonOf(e, path)}")
        }
    }

    private fun accept(name: String, path: Path, mark: FileMark): String {
        val end = if (Files.exists(path)) endOfLine(path, minOf(mark.length, Files.size(path))) else 0
        if (end > 0) beginnings[name] = Beginning.of(path, end)
        return when (end) {
            0L -> "$name: all rows up to step ${meta.step} are lost"
            mark.length -> "$name: its checksum was wrong at step ${meta.step}; its rows are kept as they are"
            else -> "$name: ${mark.length - end} of its ${mark.length} bytes up to step ${meta.step} are lost"
        }
    }

    /** The end of the last line that ends at [length] or before; 0 when there is none. */
    private fun endOfLine(path: Path, length: Long): Long = Files.newByteChannel(path).use { file ->
        var end = length
        val byte = ByteBuffer.allocate(1)
        while (end > 0) {
            file.position(end - 1).read(byte.clear())
            if (byte[0] == '\n'.code.toByte()) break
            end--
        }
        end
    }
}
