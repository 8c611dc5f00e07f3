package daphnis.app.sweep

import daphnis.core.format.FormatException
import daphnis.core.format.WholeFile
import daphnis.core.format.reasonOf
import daphnis.core.run.Version
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.IOException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.Path

/**
 * `sweep.json`: what a sweep consists of, so that the same command goes on with it and another one is refused.
 *
 * @property scenario as it is before anything is set, as JSON
 * @property keys of the settings, in their order
 * @property seeds null for the scenario's
 * @property name what the scenario was called on the command line
 */
internal class SweepRecord(
    private val scenario: JsonElement,
    private val keys: List<SweptKey>,
    private val seeds: List<Long>?,
    val name: String,
) {
    fun plan(): SweepPlan = SweepPlan(keys, seeds)

    /** The scenario with [settings]. */
    fun scenario(settings: List<String>): Scenario = ScenarioJson.parse("$scenario", name, settings)

    /** What this record has otherwise than the [earlier] one, as the end of a sentence; null when nothing. */
    fun difference(earlier: SweepRecord): String? = listOfNotNull(
        changed("", earlier.scenario, scenario),
        changedKey(earlier),
        if (seeds == earlier.seeds) null else "--seeds was ${text(earlier.seeds)} and is ${text(seeds)}",
    ).joinToString(", ").ifEmpty { null }

    private fun changedKey(earlier: SweepRecord): String? {
        val before = earlier.keys.associate { it.path to it.values.joinToString(",") }
        val now = keys.associate { it.path to it.values.joinToString(",") }
        for (path in before.keys + now.keys) {
            if (before[path] == now[path]) continue
            return "--set $path was ${before[path] ?: "not given"} and is ${now[path] ?: "not given"}"
        }
        if (before.keys.toList() != now.keys.toList()) {
            return "--set was in the order ${before.keys.joinToString()} and is ${now.keys.joinToString()}"
        }
        return null
    }

    private fun text(seeds: List<Long>?): String {
        if (seeds == null) return "not given"
        val isRange = seeds.size > 2 && seeds.last() - seeds.first() == seeds.size - 1L && seeds == seeds.sorted()
        return if (isRange) "${seeds.first()}..${seeds.last()}" else seeds.joinToString(",")
    }

    /** The first key of the scenario that has another value. */
    private fun changed(path: String, before: JsonElement?, now: JsonElement?): String? {
        if (before == now) return null
        if (before is JsonObject && now is JsonObject) {
            return (before.keys + now.keys).firstNotNullOf {
                Change(if (path.isEmpty()) it else "$path.$it", before[it], now[it]).takeIf { c -> c.before != c.now }
            }.let { changed(it.path, it.before, it.now) }
        }
        return "$path of the scenario was ${short(before)} and is ${short(now)}"
    }

    private class Change(val path: String, val before: JsonElement?, val now: JsonElement?)

    private fun short(element: JsonElement?) = "${element ?: "not given"}".let {
        if (it.length > LONGEST) it.take(LONGEST) + "…" else it
    }

    /** Writes the file, whole or not at all. */
    fun write(path: Path) {
        WholeFile.write(path, text())
    }

    /** The same where no other process has written it: the first one's stays. */
    fun writeIfFirst(path: Path) {
        val own = path.resolveSibling("${path.fileName}.${ProcessHandle.current().pid()}-${System.nanoTime()}")
        try {
            Files.writeString(own, text())
            try {
                Files.createLink(path, own)
            } catch (e: UnsupportedOperationException) {
                Files.move(own, path)
            } catch (e: FileAlreadyExistsException) {
                throw e
            } catch (e: IOException) {
                // A file system without links.
                Files.move(own, path)
            }
        } catch (e: FileAlreadyExistsException) {
            return
        } finally {
            Files.deleteIfExists(own)
        }
    }

    private fun text(): String {
        val tree = buildJsonObject {
            put("version", JsonPrimitive(Version.text))
            put("settings", JsonObject(keys.associate { it.path to JsonArray(it.values.map(::JsonPrimitive)) }))
            put("seeds", seeds?.let { JsonArray(it.map(::JsonPrimitive)) } ?: JsonPrimitive(null as String?))
            put("name", JsonPrimitive(name))
            put("scenario", scenario)
        }
        return JSON.encodeToString(JsonElement.serializer(), tree) + "\n"
    }

    companion object {
        private val JSON = Json { prettyPrint = true }
        private const val LONGEST = 60

        /** That of the runs of [plan] of the scenario [base], which was called [name]. */
        fun of(base: Scenario, plan: SweepPlan, name: String): SweepRecord =
            SweepRecord(Json.parseToJsonElement(ScenarioJson.write(base)), plan.keys, plan.seeds, name)

        /** @throws FormatException when it cannot be read or is no such file */
        fun read(path: Path): SweepRecord = try {
            val tree = JSON.parseToJsonElement(Files.readString(path)).jsonObject
            SweepRecord(
                tree.getValue("scenario"),
                tree.getValue("settings").jsonObject.map { (key, values) ->
                    SweptKey(key, values.jsonArray.map { it.jsonPrimitive.content })
                },
                (tree["seeds"] as? JsonArray)?.map { it.jsonPrimitive.content.toLong() },
                // Earlier versions did not note it.
                tree["name"]?.jsonPrimitive?.content ?: "scenario",
            )
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
        } catch (e: SerializationException) {
            throw FormatException("$path: is no record of a sweep: ${e.message.orEmpty().lineSequence().first()}")
        } catch (e: IllegalArgumentException) {
            // Other JSON, of which the library says what it is in the names of its classes.
            throw FormatException("$path: is no record of a sweep")
        } catch (e: NoSuchElementException) {
            throw FormatException("$path: is no record of a sweep: ${e.message}")
        }
    }
}
