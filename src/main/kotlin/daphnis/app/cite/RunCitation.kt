package daphnis.app.cite

import daphnis.core.format.FormatException
import daphnis.core.format.PackedFile
import daphnis.core.format.WholeFile
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import daphnis.core.run.RecordedRun
import daphnis.core.run.Summary
import daphnis.core.run.Version
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.longOrNull
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
        private const val NOT_ONE = "is not what `daphnis cite --record` writes"

        private val JsonElement.text: String? get() = (this as? JsonPrimitive)?.takeIf { it.isString }?.content

        /** What [take] makes of the value at [key], which must be [what] it says. */
        private fun <T : Any> JsonElement.must(key: String, what: String, take: (JsonElement) -> T?): T {
            val value = (this as? JsonObject)?.get(key)
            return requireNotNull(value?.let(take)) { "its $key is ${if (value == null) "missing" else "not $what"}" }
        }

        /**
         * That of a finished [run].
         *
         * @throws InputException when it has not finished, is of a program, or begins from a file
         */
        fun of(run: RecordedRun): RunCitation {
            val path = "${run.directory.path}"
            val scenario = scenarioOf(run)
            val summary = finished(run)
            if (scenario.placement.file != null) {
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
            val tree = JSON.parseToJsonElement(PackedFile.text(path, LARGEST))
            val digest = tree.must("stateDigest", "a digest of 64 hexadecimal digits") {
                it.text?.takeIf(DIGEST::matches)
            }
            RunCitation(
                tree.must("daphnis", "a version of daphnis in quotes") { it.text },
                tree.must("scenario", "a scenario, an object") { it as? JsonObject },
                tree.must("steps", "a whole number") { (it as? JsonPrimitive)?.longOrNull },
                tree.must("time", "a number") { (it as? JsonPrimitive)?.doubleOrNull },
                digest,
            )
        } catch (e: SerializationException) {
            throw FormatException("$path: $NOT_ONE: it is not JSON, or ends too early")
        } catch (e: CharacterCodingException) {
            throw FormatException("$path: is not UTF-8 text")
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
        } catch (e: IllegalArgumentException) {
            throw FormatException("$path: $NOT_ONE: ${e.message}")
        } catch (e: StackOverflowError) {
            throw FormatException("$path: is nested too deeply")
        }
    }
}
