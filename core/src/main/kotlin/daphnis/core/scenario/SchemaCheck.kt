package daphnis.core.scenario

import daphnis.core.input.InputException
import daphnis.core.input.Nearest
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.descriptors.PolymorphicKind
import kotlinx.serialization.descriptors.PrimitiveKind
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.descriptors.SerialKind
import kotlinx.serialization.descriptors.StructureKind
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * Compares a JSON tree with what a serializer expects and names the first error by its path: an unknown
 * key with the nearest known one, a missing key, a value of the wrong kind, a number that is not finite.
 *
 * A whole number may be written as 1.0 or 1e3, as in JSON Schema; the tree that comes back has it in digits, since the
 * serializer takes nothing else.
 */
@OptIn(ExperimentalSerializationApi::class)
internal class SchemaCheck(private val source: String) {
    fun check(tree: JsonElement, descriptor: SerialDescriptor): JsonElement = check(tree, descriptor, "")

    private fun check(element: JsonElement, descriptor: SerialDescriptor, path: String): JsonElement {
        if (element is JsonNull) {
            if (descriptor.isNullable) return element
            fail(path, "is null; ${expected(descriptor)}")
        }
        return when (descriptor.kind) {
            StructureKind.CLASS, StructureKind.OBJECT -> checkObject(element, descriptor, path)
            StructureKind.LIST -> {
                if (element !is JsonArray) fail(path, "is ${shown(element)}; ${expected(descriptor)}")
                JsonArray(element.mapIndexed { k, e -> check(e, descriptor.getElementDescriptor(0), "$path[$k]") })
            }
            PolymorphicKind.SEALED -> checkSealed(element, descriptor, path)
            SerialKind.ENUM -> {
                val name = (element as? JsonPrimitive)?.takeIf { it.isString }?.content
                if (name !in descriptor.names()) {
                    fail(path, "is ${shown(element)}; ${choices(name.orEmpty(), descriptor.names())}")
                }
                element
            }
            else -> checkPrimitive(element, descriptor, path)
        }
    }

    /** [type] is that of [types] which the object says it is of; null where there is only one kind. */
    private fun checkObject(
        element: JsonElement,
        descriptor: SerialDescriptor,
        path: String,
        type: String? = null,
        types: SerialDescriptor? = null,
    ): JsonElement {
        if (element !is JsonObject) fail(path, "is ${shown(element)}; ${expected(descriptor)}")
        val known = descriptor.names()
        for (key in element.keys) {
            if (key !in known && (type == null || key != "type")) {
                val which = if (type == null) "unknown key" else "unknown key for type $type"
                fail(join(path, brief(key)), "$which; ${elsewhere(key, types, path) ?: choices(key, known)}")
            }
        }
        val checked = LinkedHashMap(element)
        for (k in 0 until descriptor.elementsCount) {
            val name = descriptor.getElementName(k)
            val child = element[name]
            if (child != null) {
                checked[name] = check(child, descriptor.getElementDescriptor(k), join(path, name))
            } else if (!descriptor.isElementOptional(k)) {
                fail(join(path, name), "is missing; ${expected(descriptor.getElementDescriptor(k))}")
            }
        }
        return JsonObject(checked)
    }

    private fun checkSealed(element: JsonElement, descriptor: SerialDescriptor, path: String): JsonElement {
        if (element !is JsonObject) fail(path, "is ${shown(element)}; ${expected(descriptor)}")
        val types = descriptor.getElementDescriptor(1)
        val type = element["type"] ?: fail(join(path, "type"), missing(element, types, path))
        val name = (type as? JsonPrimitive)?.takeIf { it.isString }?.content
        if (name == null || name !in types.names()) {
            fail(join(path, "type"), "is ${shown(type)}; ${choices(name.orEmpty(), types.names())}")
        }
        return checkObject(element, types.getElementDescriptor(types.getElementIndex(name)), path, name, types)
    }

    /** Which others of [types] have [key]; null when none has. */
    private fun elsewhere(key: String, types: SerialDescriptor?, path: String): String? {
        val having = types?.names().orEmpty().filter {
            key in
                types!!.getElementDescriptor(types.getElementIndex(it)).names()
        }
        if (having.isEmpty()) return null
        return "it is a key of type ${having.joinToString(" or ")}, so give $path.type=${having[0]} too"
    }

    /** What [element] lacks is its type, which its keys may tell. */
    private fun missing(element: JsonObject, types: SerialDescriptor, path: String): String {
        val meant = types.names().filter { name ->
            types.getElementDescriptor(types.getElementIndex(name)).names().containsAll(element.keys)
        }
        val hint = if (element.isEmpty() || meant.size != 1) {
            ""
        } else {
            val verb = if (element.size == 1) "is" else "are"
            "${element.keys.joinToString()} $verb of type ${meant[0]}, so give $path.type=${meant[0]} too; "
        }
        return "is missing; ${hint}it must be one of ${types.names().joinToString()}"
    }

    private fun checkPrimitive(element: JsonElement, descriptor: SerialDescriptor, path: String): JsonElement {
        val primitive = element as? JsonPrimitive ?: fail(path, "is ${shown(element)}; ${expected(descriptor)}")
        val ok = when (descriptor.kind) {
            PrimitiveKind.STRING -> primitive.isString
            PrimitiveKind.BOOLEAN ->
                !primitive.isString &&
                    (primitive.content == "true" || primitive.content == "false")
            PrimitiveKind.INT -> whole(primitive)?.takeIf { it in Int.MIN_VALUE..Int.MAX_VALUE } != null
            PrimitiveKind.LONG -> whole(primitive) != null
            else ->
                !primitive.isString &&
                    JSON_NUMBER.matches(primitive.content) &&
                    primitive.content.toDouble().isFinite()
        }
        if (!ok) fail(path, "is ${shown(element)}; ${expected(descriptor)}")
        // It could be written into no file.
        if (!Charsets.UTF_8.newEncoder().canEncode(primitive.content)) fail(path, HALF)
        val isWhole = descriptor.kind == PrimitiveKind.INT || descriptor.kind == PrimitiveKind.LONG
        return if (isWhole) JsonPrimitive(whole(primitive)) else primitive
    }

    /** The whole number that it is; null for others. */
    private fun whole(primitive: JsonPrimitive): Long? {
        if (primitive.isString || !JSON_NUMBER.matches(primitive.content)) return null
        val value = primitive.content.toBigDecimalOrNull() ?: return null
        return try {
            value.longValueExact()
        } catch (_: ArithmeticException) {
            null
        }
    }

    private fun expected(descriptor: SerialDescriptor): String = "it must be " + when (descriptor.kind) {
        PrimitiveKind.STRING -> "a string"
        PrimitiveKind.BOOLEAN -> "true or false"
        PrimitiveKind.INT -> "a whole number below 2147483648"
        PrimitiveKind.LONG -> "a whole number of at most 64 bits"
        PrimitiveKind.DOUBLE -> "a finite number"
        StructureKind.LIST -> "a list"
        PolymorphicKind.SEALED ->
            "an object whose type is one of ${descriptor.getElementDescriptor(1).names().joinToString()}"
        SerialKind.ENUM -> "one of ${descriptor.names().joinToString()}"
        else -> "an object with ${descriptor.names().joinToString()}"
    }

    private fun choices(word: String, known: List<String>): String {
        if (known.isEmpty()) return "no key is known here"
        return "${Nearest.question(word, known)}known: ${known.joinToString()}"
    }

    private fun SerialDescriptor.names(): List<String> = (0 until elementsCount).map { getElementName(it) }

    private fun shown(element: JsonElement): String =
        brief(element.toString().take(MOST_LOOKED_AT).replace(Regex("\\s+"), " "))

    private fun brief(text: String): String = if (text.length > MOST_SHOWN) text.take(MOST_SHOWN) + "…" else text

    private fun join(path: String, key: String) = if (path.isEmpty()) key else "$path.$key"

    private fun fail(path: String, problem: String): Nothing = throw InputException(
        source,
        path.ifEmpty {
            null
        },
        problem,
    )

    private companion object {
        const val HALF = "has half of a character (one of \\ud800 to \\udfff without its other half); give both halves"

        const val MOST_SHOWN = 40
        const val MOST_LOOKED_AT = 1000
        val JSON_NUMBER = Regex("""-?\d+(\.\d+)?([eE][+-]?\d+)?""")
    }
}
