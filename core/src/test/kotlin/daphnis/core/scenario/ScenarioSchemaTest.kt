package daphnis.core.scenario

import daphnis.core.Repository
import daphnis.core.input.InputException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.nio.file.Files

/** Editors check scenarios as the program does. */
@Tag("jdk-neutral")
class ScenarioSchemaTest {
    private val schema = Json.parseToJsonElement(ScenarioSchema.text()).jsonObject

    @Test
    fun `the published file is that of the declarations`() {
        val file = Repository.root.resolve("docs/scenario.schema.json")
        if (System.getProperty("daphnis.reference") == "write") Files.writeString(file, ScenarioSchema.text())
        assertEquals(ScenarioSchema.text(), Files.readString(file)) {
            "write it anew: ./daphnis scenarios --schema > docs/scenario.schema.json, or -Ddaphnis.reference=write"
        }
    }

    @Test
    fun `every built-in scenario fits`() {
        for (name in BuiltIn.names) {
            val tree = Json.parseToJsonElement(ScenarioJson.write(BuiltIn.scenario(name)))
            assertEquals(emptyList<String>(), problems(tree, schema, ""), name)
        }
    }

    @Test
    fun `what the program refuses does not fit`() {
        val good = Json.parseToJsonElement(ScenarioJson.write(BuiltIn.scenario("ring-patch"))).jsonObject
        val wrong = mapOf(
            "boks" to JsonPrimitive(1),
            "until" to JsonPrimitive("soon"),
            "restitution" to Json.parseToJsonElement("""{"type": "constant"}"""),
            "boundary" to Json.parseToJsonElement("""{"type": "wals"}"""),
            "search" to JsonPrimitive("slow"),
            "forces" to JsonObject(emptyMap()),
        )
        for ((key, value) in wrong) {
            assertTrue(
                problems(JsonObject(good + (key to value)), schema, "").isNotEmpty(),
                key,
            )
        }
        assertTrue(problems(JsonObject(good - "box"), schema, "").isNotEmpty())
    }

    @Test
    fun `a file may name its schema`() {
        val text = ScenarioJson.write(BuiltIn.scenario("cooling-gas"))
        val named = text.replaceFirst("{", "{ \"${ScenarioSchema.KEY}\": \"${ScenarioSchema.ADDRESS}\",")
        val wrong = text.replaceFirst("{", "{ \"${ScenarioSchema.KEY}\": 7,")
        val e = assertThrows(InputException::class.java) { ScenarioJson.parse(wrong, "test", emptyList()) }
        assertEquals("test: ${ScenarioSchema.KEY}: is 7; it must be text, the address of a schema", e.message)
        assertEquals(text, ScenarioJson.write(ScenarioJson.parse(named, "mine")))
    }

    /** As much of a validator as the schema needs. */
    private fun problems(value: JsonElement, rule: JsonObject, path: String): List<String> {
        rule["\$ref"]?.let { return problems(value, definition(it.jsonPrimitive.content), path) }
        rule["oneOf"]?.let { all ->
            val fitting = all.jsonArray.count { problems(value, it.jsonObject, path).isEmpty() }
            return if (fitting == 1) emptyList() else listOf("$path fits $fitting")
        }
        rule["const"]?.let { return if (it == value) emptyList() else listOf("$path is $value") }
        rule["enum"]?.let { return if (value in it.jsonArray) emptyList() else listOf("$path is $value") }
        val primitive = value as? JsonPrimitive
        return when (val type = rule.getValue("type").jsonPrimitive.content) {
            "object" -> if (value is JsonObject) fields(value, rule, path) else listOf("$path is no object")
            "array" -> (value as? JsonArray)?.flatMapIndexed { k, one ->
                problems(one, rule.getValue("items").jsonObject, "$path[$k]")
            } ?: listOf("$path is no list")
            else -> if (primitive != null && isOf(primitive, type)) emptyList() else listOf("$path is no $type")
        }
    }

    private fun definition(address: String) =
        schema.getValue("\$defs").jsonObject.getValue(address.removePrefix("#/\$defs/")).jsonObject

    private fun fields(value: JsonObject, rule: JsonObject, path: String): List<String> {
        val known = rule.getValue("properties").jsonObject
        val missing = rule["required"]?.jsonArray.orEmpty().map { it.jsonPrimitive.content }.filter { it !in value }
        return missing.map { "$path.$it is missing" } + value.flatMap { (key, one) ->
            known[key]?.let { problems(one, it.jsonObject, "$path.$key") } ?: listOf("$path.$key is unknown")
        }
    }

    private fun isOf(value: JsonPrimitive, type: String) = when (type) {
        "string" -> value.isString
        "boolean" -> value.content in listOf("true", "false")
        "null" -> value.content == "null"
        "integer" -> !value.isString && value.content.toLongOrNull() != null
        else -> !value.isString && value.content.toDoubleOrNull() != null
    }
}
