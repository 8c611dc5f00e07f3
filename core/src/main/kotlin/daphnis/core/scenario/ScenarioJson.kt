package daphnis.core.scenario

import daphnis.core.format.PackedFile
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.intOrNull
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path

/** Reads and writes [Scenario]s as JSON. Every error in the text is an [InputException]. */
public object ScenarioJson {
    @OptIn(ExperimentalSerializationApi::class)
    private val json = Json {
        allowComments = true
        allowTrailingComma = true
        encodeDefaults = true
        explicitNulls = false
        prettyPrint = true
    }

    /**
     * Parses [text].
     *
     * @param source what to call it in messages
     * @param settings `path=value` pairs that replace keys, as on the command line, see [Settings]
     */
    @JvmStatic
    @JvmOverloads
    public fun parse(text: String, source: String, settings: List<String> = emptyList()): Scenario = try {
        val given = Settings.apply(withoutSchema(parseTree(text.removePrefix("\uFEFF"), source), source), settings)
        val tree = SchemaCheck(source).check(given, Scenario.serializer().descriptor)
        checkOutput(tree, source)
        json.decodeFromJsonElement(Scenario.serializer(), tree)
    } catch (e: SerializationException) {
        throw InputException(source, null, e.message.orEmpty())
    } catch (e: IllegalArgumentException) {
        throw InputException(source, null, e.message.orEmpty())
    } catch (e: StackOverflowError) {
        throw InputException(source, null, "is nested too deeply")
    }

    /** Reads the file [path], which gzip may have packed. */
    @JvmStatic
    @JvmOverloads
    public fun read(path: Path, settings: List<String> = emptyList()): Scenario {
        val text = try {
            if (Files.size(path) > LARGEST) {
                throw InputException(path.toString(), null, "is larger than $LARGEST bytes, which is no scenario")
            }
            PackedFile.text(path, LARGEST.toInt())
        } catch (e: NoSuchFileException) {
            throw InputException(path.toString(), null, "no such file")
        } catch (e: CharacterCodingException) {
            throw InputException(path.toString(), null, "is not UTF-8 text")
        } catch (e: IOException) {
            throw InputException(path.toString(), null, "cannot be read: ${reasonOf(e, path)}")
        }
        return parse(text, path.toString(), settings)
    }

    /**
     * [scenario] with keys replaced.
     *
     * @param source what to call it in messages
     * @param settings as for [parse]
     */
    @JvmStatic
    public fun changed(scenario: Scenario, source: String, settings: List<String>): Scenario =
        parse(write(scenario), source, settings)

    /** The whole scenario, with every default written out. */
    @JvmStatic
    public fun write(scenario: Scenario): String =
        json.encodeToString(Scenario.serializer(), scenario.copy(output = scenario.output.settled(null))) + "\n"

    /** The text for the file of a run directory, which [read] reads as a scenario. */
    @JvmStatic
    public fun write(scenario: ResolvedScenario): String = write(scenario.document)

    /** A number of steps that is a default is not given, which the scenario itself cannot tell. */
    private fun checkOutput(tree: JsonElement, source: String) {
        val given = tree.jsonObject["output"]?.jsonObject ?: return
        for ((key, interval) in given) {
            if (!key.endsWith(OutputSpec.INTERVAL) || interval is JsonNull) continue
            val every = OutputSpec.counterpart(key)
            val steps = given[every]?.jsonPrimitive?.intOrNull ?: continue
            val both = "is given together with $every; ${OutputSpec.ONE_OF_TWO}"
            if (steps != 0) throw InputException(source, "output.$key", both)
        }
    }

    private fun parseTree(text: String, source: String): JsonElement = try {
        json.parseToJsonElement(text).also { _ ->
            val twice = RepeatedKey.find(text)
            if (twice != null) {
                val first = place(text, twice.firstOffset).substringBefore(':')
                val why = "is given twice, first in line $first; leave one of them out"
                throw InputException("$source:${place(text, twice.offset)}", twice.path, why)
            }
        }
    } catch (e: SerializationException) {
        throw malformed(e, text, source)
    }

    /** A file may name its [schema][ScenarioSchema], for editors. */
    private fun withoutSchema(tree: JsonElement, source: String): JsonElement {
        if (tree !is JsonObject) return tree
        val schema = tree[ScenarioSchema.KEY] ?: return tree
        if (schema !is JsonPrimitive || !schema.isString) {
            throw InputException(source, ScenarioSchema.KEY, "is $schema; it must be text, the address of a schema")
        }
        return JsonObject(tree - ScenarioSchema.KEY)
    }

    private fun malformed(e: SerializationException, text: String, source: String): InputException {
        if (text.isBlank()) {
            val right = "a scenario is a JSON object; daphnis scenarios NAME prints one that is built in"
            return InputException(source, null, "is empty; $right")
        }
        val message = e.message.orEmpty()
        val offset = Regex("""offset (-?\d+)""").find(message)?.groupValues?.get(1)?.toInt()?.coerceIn(0, text.length)
        val said = message.substringAfter(": ").lineSequence().first().substringBefore(" at path").trim()
        val problem = OF_THE_LIBRARY.entries.fold(said) { text, (its, ours) -> text.replace(its, ours) }
        if (offset == null) return InputException(source, null, "malformed JSON: $problem")
        return InputException("$source:${place(text, offset)}", null, "malformed JSON: $problem")
    }

    /** Line and column of [offset] in [text], both from 1. */
    private fun place(text: String, offset: Int): String {
        val line = text.substring(0, offset).count { it == '\n' } + 1
        val column = offset - (text.lastIndexOf('\n', offset - 1) + 1) + 1
        return "$line:$column"
    }

    private const val LARGEST = 64L shl 20

    /** What the library says of the end of the text, and what a reader understands. */
    private val OF_THE_LIBRARY = mapOf(
        "Cannot read Json element because of unexpected end of the input" to "the text ends too early",
        "but had 'EOF' instead" to "but the text ends",
        "Expected EOF after parsing" to "Expected the end of the text",
    )
}
