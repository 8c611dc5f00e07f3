package daphnis.app.cite

import daphnis.core.format.FormatException
import daphnis.core.format.PackedFile
import daphnis.core.format.WholeFile
import daphnis.core.format.reasonOf
import daphnis.core.run.RecordedRun
import daphnis.core.run.Summary
import daphnis.core.run.Version
import daphnis.core.scenario.InputException
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Path

/**
 * What anyone needs to do a run again and to know that it came out the same: one file of JSON.
 *
 * @property daphnis the version that ran it
 * @property scenario with every default written out
 * @property steps at the end
 * @property time at the end, in the scenario's unit of time
 * @property stateDigest of the final state
 */
@Serializable
internal data class RunCitation(
    val daphnis: String,
    val scenario: JsonObject,
    val steps: Long,
    val time: Double,
    val stateDigest: String,
) {
    fun write(path: Path): Unit = WholeFile.write(path, JSON.encodeToString(serializer(), this) + "\n")

    /** The scenario with [settings], `path=value` each. */
    fun scenario(source: String, settings: List<String>): Scenario =
        ScenarioJson.parse(scenario.toString(), source, settings)

    companion object {
        private const val LARGEST = 16 shl 20
        private val JSON = Json { prettyPrint = true }
        private val DIGEST = Regex("[0-9a-f]{64}")

        /**
         * That of a finished [run].
         *
         * @throws InputException when it has not finished, is of a program, or begins from a file
         */
        fun of(run: RecordedRun): RunCitation {
            val path = "${run.directory.path}"
            val scenario = scenarioOf(run)
            val summary = finished(run)
            if (scenario.placement is PlacementSpec.File) {
                val mend = "give the run directory itself, and pass that on"
                throw InputException(path, null, "begins from a state in a file, which a citation does not hold; $mend")
            }
            val tree = Json.parseToJsonElement(ScenarioJson.write(scenario)).jsonObject
            return RunCitation(summary.version, tree, summary.steps, summary.time, summary.stateDigest)
        }

        /** @throws InputException when [run] is of a program */
        fun scenarioOf(run: RecordedRun): Scenario = run.scenario() ?: throw InputException(
            "${run.directory.path}",
            null,
            "is of a program, and only that can do the run again",
        )

        /** @throws InputException when [run] has not finished */
        fun finished(run: RecordedRun): Summary = run.summary()?.takeIf { it.finished } ?: throw InputException(
            "${run.directory.path}",
            null,
            "has not finished; continue with: ${Version.command} resume ${run.directory.path}",
        )

        /** @throws FormatException when [path] cannot be read or is none */
        fun read(path: Path): RunCitation = try {
            val citation = JSON.decodeFromString(serializer(), PackedFile.text(path, LARGEST))
            require(DIGEST.matches(citation.stateDigest)) { "stateDigest is no digest of 64 hexadecimal digits" }
            citation
        } catch (e: CharacterCodingException) {
            throw FormatException("$path: is not UTF-8 text")
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
        } catch (e: IllegalArgumentException) {
            val why = e.message.orEmpty().lineSequence().first()
            throw FormatException("$path: is not what `daphnis cite --record` writes: $why")
        } catch (e: StackOverflowError) {
            throw FormatException("$path: is nested too deeply")
        }
    }
}
