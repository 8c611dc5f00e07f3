package daphnis.core.scenario

import daphnis.core.input.Described
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.descriptors.PolymorphicKind
import kotlinx.serialization.descriptors.PrimitiveKind
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.descriptors.SerialKind
import kotlinx.serialization.descriptors.StructureKind
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject

/**
 * The JSON Schema (draft 2020-12) of scenario files, made from their declarations, with which editors complete keys and
 * mark what is wrong. It knows keys, types and which are needed, as [SchemaCheck] does, and no ranges; what a key means
 * it has from [Described].
 */
@OptIn(ExperimentalSerializationApi::class)
public object ScenarioSchema {
    /** Where the schema is published; a scenario may name it as its [KEY]. */
    public const val ADDRESS: String = "https://daphnis-sim.github.io/daphnis/scenario.schema.json"

    /** The key by which a file of JSON names its schema. */
    public const val KEY: String = "\$schema"

    private val json = Json {
        prettyPrint = true
        prettyPrintIndent = "  "
    }

    /** The schema as text. */
    @JvmStatic
    public fun text(): String = json.encodeToString(JsonElement.serializer(), Maker().whole()) + "\n"

    private class Maker {
        private val definitions = sortedMapOf<String, JsonElement>()
        private val names = HashMap<String, String>()

        fun whole(): JsonObject {
            val scenario = fields(Scenario.serializer().descriptor, null, mapOf(KEY to text("string")))
            return buildJsonObject {
                put(KEY, JsonPrimitive("https://json-schema.org/draft/2020-12/schema"))
                put("\$id", JsonPrimitive(ADDRESS))
                put("title", JsonPrimitive("A scenario of daphnis"))
                scenario.forEach { (key, value) -> put(key, value) }
                put("\$defs", JsonObject(definitions))
            }
        }

        private fun of(descriptor: SerialDescriptor): JsonObject {
            val plain = when (descriptor.kind) {
                StructureKind.CLASS, StructureKind.OBJECT -> defined(descriptor) { fields(descriptor, null) }
                PolymorphicKind.SEALED -> defined(descriptor) { oneOf(types(descriptor)) }
                StructureKind.LIST -> JsonObject(text("array") + ("items" to of(descriptor.getElementDescriptor(0))))
                SerialKind.ENUM -> JsonObject(mapOf("enum" to JsonArray(names(descriptor).map { JsonPrimitive(it) })))
                PrimitiveKind.STRING -> text("string")
                PrimitiveKind.BOOLEAN -> text("boolean")
                PrimitiveKind.INT, PrimitiveKind.LONG -> text("integer")
                else -> text("number")
            }
            return if (descriptor.isNullable) oneOf(listOf(plain, text("null"))) else plain
        }

        private fun types(descriptor: SerialDescriptor): List<JsonObject> {
            val types = descriptor.getElementDescriptor(1)
            return names(types).map {
                val type = types.getElementDescriptor(types.getElementIndex(it))
                described(fields(type, it), type.annotations)
            }
        }

        /** A reference to what [make] makes, which is in the schema once. */
        private fun defined(descriptor: SerialDescriptor, make: () -> JsonObject): JsonObject {
            val whole = descriptor.serialName.removeSuffix("?")
            val name = whole.substringAfterLast('.')
            check(names.getOrPut(name) { whole } == whole) { "two declarations are called $name" }
            if (name !in definitions) {
                definitions[name] = JsonObject(emptyMap())
                definitions[name] = make()
            }
            return JsonObject(mapOf("\$ref" to JsonPrimitive("#/\$defs/$name")))
        }

        /**
         * An object with the fields of [descriptor] and with [others], which says that it is of [type] if there is one.
         */
        private fun fields(
            descriptor: SerialDescriptor,
            type: String?,
            others: Map<String, JsonElement> = emptyMap(),
        ): JsonObject {
            val kind = type?.let { mapOf("type" to JsonObject(mapOf("const" to JsonPrimitive(it)))) }.orEmpty()
            val own = (0 until descriptor.elementsCount).associate {
                val plain = of(descriptor.getElementDescriptor(it))
                descriptor.getElementName(it) to described(plain, descriptor.getElementAnnotations(it))
            }
            val needed = kind.keys +
                (0 until descriptor.elementsCount).filterNot { descriptor.isElementOptional(it) }
                    .map { descriptor.getElementName(it) }
            return buildJsonObject {
                put("type", JsonPrimitive("object"))
                put("properties", JsonObject(others + kind + own))
                if (needed.isNotEmpty()) put("required", JsonArray(needed.map { JsonPrimitive(it) }))
                put("additionalProperties", JsonPrimitive(false))
            }
        }

        private fun described(plain: JsonObject, annotations: List<Annotation>): JsonObject {
            val text = annotations.filterIsInstance<Described>().firstOrNull()?.text ?: return plain
            return JsonObject(mapOf("description" to JsonPrimitive(text)) + plain)
        }

        private fun oneOf(all: List<JsonObject>) = JsonObject(mapOf("oneOf" to JsonArray(all)))

        private fun text(type: String) = JsonObject(mapOf("type" to JsonPrimitive(type)))

        private fun names(descriptor: SerialDescriptor) =
            (0 until descriptor.elementsCount).map { descriptor.getElementName(it) }
    }
}
