package daphnis.app

import daphnis.core.scenario.ScenarioSchema
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive

/**
 * What `--set` may begin with, for the completion of shells: `path=` of each key of a scenario, and `path=value` where
 * the schema knows the values. Lists show their first entry.
 */
internal object SettingWords {
    val all: List<String> by lazy {
        val whole = Json.parseToJsonElement(ScenarioSchema.text()).jsonObject
        val found = LinkedHashMap<String, LinkedHashSet<String>>()
        Walk(whole.getValue("\$defs").jsonObject, found).into(whole, "")
        found.remove(ScenarioSchema.KEY)
        found.getValue("engine.name") += allEngines.names
        found.flatMap { (path, values) -> values.map { "$path=$it" }.ifEmpty { listOf("$path=") } }
    }

    private class Walk(
        private val definitions: JsonObject,
        private val found: LinkedHashMap<String, LinkedHashSet<String>>,
    ) {
        fun into(schema: JsonObject, path: String) {
            val properties = schema["properties"]?.jsonObject
            val values = schema["enum"]?.jsonArray ?: schema["const"]?.let { JsonArray(listOf(it)) }
            val type = schema["type"]?.jsonPrimitive?.content
            when {
                "\$ref" in schema -> into(definitions.getValue(name(schema)).jsonObject, path)
                "oneOf" in schema -> schema.getValue("oneOf").jsonArray.forEach { into(it.jsonObject, path) }
                properties != null -> properties.forEach { (key, of) -> into(of.jsonObject, "$path.$key".trim('.')) }
                values != null -> at(path) += values.map { it.jsonPrimitive.content }
                type == "boolean" -> at(path) += listOf("true", "false")
                type == "array" && "\$ref" in schema.getValue("items").jsonObject ->
                    into(schema.getValue("items").jsonObject, "$path[0]")
                type != "null" -> at(path)
            }
        }

        private fun at(path: String) = found.getOrPut(path) { LinkedHashSet() }

        private fun name(schema: JsonObject) = schema.getValue("\$ref").jsonPrimitive.content.substringAfterLast('/')
    }
}
