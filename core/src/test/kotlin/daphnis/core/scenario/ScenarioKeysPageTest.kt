package daphnis.core.scenario

import daphnis.core.GeneratedPage
import daphnis.core.collision.GuardSpec
import daphnis.core.initial.SizesSpec
import daphnis.core.initial.SpinsSpec
import daphnis.core.initial.VelocitiesSpec
import daphnis.core.input.UnitsSpec
import daphnis.core.merging.MergingSpec
import daphnis.core.potential.InteractionSpec
import daphnis.core.surface.RestitutionSpec
import daphnis.core.surface.RoughnessSpec
import kotlinx.serialization.KSerializer
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** `docs/reference/scenario-keys.md` is made from the schema, and so from what stands beside each declaration. */
@Tag("jdk-neutral")
class ScenarioKeysPageTest {
    private val schema = Json.parseToJsonElement(ScenarioSchema.text()).jsonObject
    private val definitions = schema.getValue("\$defs").jsonObject

    /** Path of the first use of each definition, in the order of the page. */
    private val places = LinkedHashMap<String, String>()

    private fun JsonObject.text(key: String) = this[key]?.jsonPrimitive?.content

    private fun name(rule: JsonObject) = rule.text("\$ref")?.removePrefix("#/\$defs/")

    /** What [rule] says besides that a value may be null. */
    private fun plain(rule: JsonObject): JsonObject {
        val some = rule["oneOf"]?.jsonArray?.map { it.jsonObject }.orEmpty().filter { it.text("type") != "null" }
        return some.singleOrNull() ?: rule
    }

    /** Objects of one kind, or of each `type` of it. */
    private fun kinds(rule: JsonObject) = rule["oneOf"]?.jsonArray?.map { it.jsonObject } ?: listOf(rule)

    private fun type(kind: JsonObject) = kind["properties"]!!.jsonObject["type"]?.jsonObject?.text("const")

    private fun keys(kind: JsonObject) = kind.getValue("properties").jsonObject.mapValues { it.value.jsonObject }
        .filterKeys { it != ScenarioSchema.KEY && it != "type" }

    private fun isNeeded(kind: JsonObject, key: String) =
        kind["required"]?.jsonArray.orEmpty().any { it.jsonPrimitive.content == key }

    /** Finds where definitions are used first, level by level. */
    private fun place(rule: JsonObject, prefix: String) {
        val found = kinds(rule).flatMap { keys(it).entries }.mapNotNull { (key, one) ->
            val inner = plain(one).let { if (it.text("type") == "array") it.getValue("items").jsonObject else it }
            val list = if (plain(one).text("type") == "array") "[]" else ""
            name(inner)?.takeIf { it !in places }?.also { places[it] = "$prefix$key$list" }
        }
        for (name in found) place(definitions.getValue(name).jsonObject, "${places.getValue(name)}.")
    }

    private fun value(rule: JsonObject): String {
        val plain = plain(rule)
        name(plain)?.let { name ->
            val heading = places.getValue(name)
            return "[$heading](#${heading.filter { it.isLetterOrDigit() }.lowercase()})"
        }
        if ("enum" in plain) return "text"
        return when (plain.text("type")) {
            "array" -> "list of " + value(plain.getValue("items").jsonObject).replace(ONE, "$1s")
            "integer" -> "whole number"
            "boolean" -> "true or false"
            "string" -> "text"
            else -> plain.text("type")!!
        }
    }

    private fun cells(kind: JsonObject, key: String, rule: JsonObject): Array<String> {
        val text = rule.text("description").orEmpty()
        val default = if (isNeeded(kind, key)) "needed" else text.substringAfter(DEFAULT, "")
        return arrayOf("`$key`", value(rule), text.substringBefore(DEFAULT), default)
    }

    private fun section(rule: JsonObject): String {
        val all = kinds(rule)
        if (all.none { type(it) != null }) {
            return GeneratedPage.head("key", "value", "meaning", "default") +
                keys(rule).entries.joinToString("") { (key, one) -> GeneratedPage.row(*cells(rule, key, one)) }
        }
        return GeneratedPage.head("`type`", "key", "value", "meaning", "default") + all.joinToString("") { kind ->
            GeneratedPage.row("`${type(kind)}`", "", "", kind.text("description").orEmpty(), "") +
                keys(kind).entries.joinToString("") { (key, one) -> GeneratedPage.row("", *cells(kind, key, one)) }
        }
    }

    @Test
    fun `the page is what the declarations say`() {
        place(schema, "")
        val text =
            "[Scenarios](../scenario.md) explains how they go together, and has examples. Lengths, times and\n" +
                "masses are in the scenario's units. A path such as `boundary.faces` is also what `--set` takes;\n" +
                "`[]` is a list.\n\n" +
                "## The scenario\n\n" + section(schema) +
                places.entries.joinToString("") { (name, path) ->
                    "\n## $path\n\n" + section(definitions.getValue(name).jsonObject)
                }
        GeneratedPage("docs/reference/scenario-keys.md", "Keys of a scenario", "the declarations of the keys")
            .check(text, javaClass, "core")
    }

    @Test
    fun `every key and every type is described`() {
        val all = (definitions + ("Scenario" to schema)).flatMap { (name, rule) ->
            kinds(rule.jsonObject).flatMap { kind ->
                val type = type(kind)
                val lacking = keys(kind).filterValues {
                    it.text("description").isNullOrEmpty()
                }.keys.map { "$name.$it" }
                lacking +
                    if (type != null && kind.text("description").isNullOrEmpty()) listOf("$name:$type") else listOf()
            }
        }
        assertEquals(emptyList<String>(), all)
    }

    /** The least that is an object of [kind]. */
    private fun least(kind: JsonObject): JsonObject {
        val properties = kind.getValue("properties").jsonObject
        val needed = kind["required"]?.jsonArray.orEmpty().map { it.jsonPrimitive.content }
        return JsonObject(needed.associateWith { some(properties.getValue(it).jsonObject) })
    }

    private fun some(rule: JsonObject): JsonElement {
        val plain = plain(rule)
        name(plain)?.let { return least(kinds(definitions.getValue(it).jsonObject).first()) }
        plain["const"]?.let { return it }
        plain["enum"]?.let { return it.jsonArray[0] }
        return when (plain.text("type")) {
            "array" -> JsonArray(emptyList())
            "string" -> JsonPrimitive("a")
            "boolean" -> JsonPrimitive(true)
            else -> JsonPrimitive(1)
        }
    }

    @Test
    fun `defaults that are told are those of the declarations`() {
        var compared = 0
        for ((name, serializer) in DECLARED) {
            val rule = if (name == "Scenario") schema else definitions.getValue(name).jsonObject
            for (kind in kinds(rule)) {
                val made = Json.decodeFromJsonElement(serializer, least(kind))!!
                for ((key, one) in keys(kind)) {
                    if (isNeeded(kind, key)) continue
                    val told = one.text("description")!!.substringAfter(DEFAULT, "").replace('−', '-').replace("`", "")
                    val field = made.javaClass.getDeclaredField(key).apply { isAccessible = true }
                    val words = when (val value = field.get(made)) {
                        is Number, is Boolean, is String, is Enum<*> -> value.toString().lowercase().replace('_', '-')
                        is List<*> -> value.takeIf { it.isNotEmpty() }?.toString()
                        else -> null
                    }?.replace(Regex("\\.0\\b"), "")?.ifEmpty { "empty" }
                    if (words != null) {
                        compared++
                        assertEquals(words, told) { "$name.$key" }
                    } else {
                        // A state from a file that does not say its time is of time 0, and of density 1.
                        val isPlain = told.toDoubleOrNull() == null || made is PlacementSpec.File
                        assertTrue(isPlain) { "$name.$key" }
                    }
                }
            }
        }
        assertTrue(compared > 60) { "only $compared" }
    }

    private companion object {
        const val DEFAULT = "; default "
        val ONE = Regex("^(number|list)(?!s)\\b")

        val DECLARED: Map<String, KSerializer<out Any>> = mapOf(
            "Scenario" to Scenario.serializer(),
            "BodySpec" to BodySpec.serializer(),
            "BoundarySpec" to BoundarySpec.serializer(),
            "EngineSpec" to EngineSpec.serializer(),
            "ForceSpec" to ForceKinds,
            "FrameSpec" to FrameSpec.serializer(),
            "GrowthSpec" to GrowthSpec.serializer(),
            "GuardSpec" to GuardSpec.serializer(),
            "InteractionSpec" to InteractionSpec.serializer(),
            "MaterialSpec" to MaterialSpec.serializer(),
            "MergingSpec" to MergingSpec.serializer(),
            "OblatenessSpec" to OblatenessSpec.serializer(),
            "OutputSpec" to OutputSpec.serializer(),
            "ParticlesSpec" to ParticlesSpec.serializer(),
            "PlacementSpec" to PlacementSpec.serializer(),
            "RestitutionSpec" to RestitutionSpec.serializer(),
            "RoughnessSpec" to RoughnessSpec.serializer(),
            "SizesSpec" to SizesSpec.serializer(),
            "SourceSpec" to SourceSpec.serializer(),
            "SpinsSpec" to SpinsSpec.serializer(),
            "TimeStepSpec" to TimeStepSpec.serializer(),
            "UnitsSpec" to UnitsSpec.serializer(),
            "VelocitiesSpec" to VelocitiesSpec.serializer(),
            "WallMotionSpec" to WallMotionSpec.serializer(),
            "WallSurfaceSpec" to WallSurfaceSpec.serializer(),
        )
    }
}
