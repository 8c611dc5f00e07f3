package daphnis.core.run

import daphnis.core.format.PackedFile
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.file.Path

/** `run.json`: the program that made a run, in place of a scenario. */
@Serializable
public class ProgramRecord internal constructor(public val program: String, public val version: String) {
    internal fun text(): String = JSON.encodeToString(serializer(), this) + "\n"

    /** Whether [other] makes the same run. */
    internal fun isSame(other: ProgramRecord): Boolean = program == other.program && version == other.version

    override fun toString(): String = "the program '$program', version '$version'"

    public companion object {
        private val JSON = Json { prettyPrint = true }

        /** Reads the `run.json` of a run. @throws InputException when it cannot be read or is not such a file */
        @JvmStatic
        public fun read(path: Path): ProgramRecord = try {
            parse(PackedFile.text(path), "$path")
        } catch (e: IOException) {
            throw InputException("$path", null, "cannot be read: ${reasonOf(e, path)}")
        }

        internal fun parse(text: String, source: String): ProgramRecord = try {
            JSON.decodeFromString(serializer(), text)
        } catch (e: IllegalArgumentException) {
            val why = e.message.orEmpty().lineSequence().first()
            throw InputException(source, null, "does not name a program of daphnis: $why")
        }
    }
}
