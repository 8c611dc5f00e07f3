package daphnis.drills

import daphnis.core.initial.SeededRandom
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.JsonUnquotedLiteral
import kotlin.math.pow

/** Changes of a scenario's tree and text of the kind that a tired or a hostile hand makes. */
internal class ScenarioMutation(private val random: SeededRandom, private val others: List<JsonObject>) {
    fun text(seed: JsonObject): ByteArray {
        var tree: JsonElement = seed
        repeat(pick(listOf(1, 1, 1, 2, 3))) { tree = mutate(tree) }
        val text = tree.toString()
        return if (random.nextInt(8) == 0) damaged(text) else text.toByteArray()
    }

    private fun <T> pick(from: List<T>): T = from[random.nextInt(from.size)]

    private fun mutate(tree: JsonElement): JsonElement {
        val at = pick(paths(tree))
        val value = get(tree, at)
        val isNumber = value is JsonPrimitive && !value.isString && value.content.toDoubleOrNull() != null
        return when (random.nextInt(20)) {
            in 0..11 -> put(tree, at, if (isNumber) number() else pick(odd()))
            12, 13 -> put(tree, at, null)
            14 -> put(tree, at, pick(odd()))
            15 -> put(tree, at, if (value is JsonObject) JsonObject(value + (pick(KEYS) to pick(odd()))) else number())
            16 -> put(tree, at, if (value is JsonArray) JsonArray(value + more()) else number())
            17 -> put(tree, at, get(tree, pick(paths(tree))))
            else -> {
                val other = pick(others)
                val key = pick(other.keys.toList())
                JsonObject((tree as JsonObject) + (key to other.getValue(key)))
            }
        }
    }

    private fun more(): List<JsonElement> = List(pick(listOf(1, 2, 100_000))) { JsonPrimitive(1) }

    @OptIn(ExperimentalSerializationApi::class)
    private fun number(): JsonElement = JsonUnquotedLiteral(
        when (random.nextInt(3)) {
            0 -> pick(NUMBERS)
            1 -> "${(if (random.nextInt(2) == 0) 1 else -1) * 10.0.pow(random.nextDouble(-300.0, 300.0))}"
            else -> "${10.0.pow(random.nextDouble(-6.0, 6.0))}"
        },
    )

    private fun odd(): List<JsonElement> = listOf(
        JsonNull, JsonPrimitive(true), JsonPrimitive(""), JsonPrimitive("1e5"), JsonPrimitive("\u0000"),
        JsonPrimitive("ü\u202e\u001b[2J"), JsonPrimitive("../../x"), JsonArray(emptyList()), JsonObject(emptyMap()),
        JsonArray(List(3) { JsonPrimitive(1) }), JsonObject(mapOf("type" to JsonPrimitive("x"))),
        JsonPrimitive("a".repeat(if (random.nextInt(20) == 0) 1 shl 20 else 300)),
        nested(pick(listOf(10, 200))), number(),
    )

    private fun nested(depth: Int): JsonElement {
        var element: JsonElement = JsonPrimitive(1)
        repeat(depth) { element = if (it % 2 == 0) JsonArray(listOf(element)) else JsonObject(mapOf("a" to element)) }
        return element
    }

    private fun damaged(text: String): ByteArray {
        val bytes = text.toByteArray()
        val depth = pick(listOf(100, 5000, 100_000))
        return when (random.nextInt(10)) {
            0 -> bytes.copyOf(random.nextInt(bytes.size))
            1 -> bytes.also {
                for (k in 0..random.nextInt(4)) it[random.nextInt(it.size)] = random.nextInt(256).toByte()
            }
            2 -> text.replaceFirst("\"until\":", "\"until\":99999,\"until\":").toByteArray()
            3 -> byteArrayOf(0xEF.toByte(), 0xBB.toByte(), 0xBF.toByte()) + bytes
            4 -> text.toByteArray(Charsets.UTF_16)
            5 -> "[".repeat(depth).toByteArray()
            6 -> "${text.dropLast(1)},\"name\":${"{\"a\":".repeat(depth)}1${"}".repeat(depth)}}".toByteArray()
            7 -> bytes + byteArrayOf(0) + bytes
            8 -> text.replaceFirst("0.", "1e9999999999").toByteArray()
            else -> pick(FRAGMENTS).toByteArray()
        }
    }

    private fun paths(tree: JsonElement, here: List<Any> = emptyList()): List<List<Any>> =
        (if (here.isEmpty()) emptyList() else listOf(here)) + when (tree) {
            is JsonObject -> tree.flatMap { (key, value) -> paths(value, here + key) }
            is JsonArray -> tree.take(MOST_LISTED).flatMapIndexed { k, value -> paths(value, here + k) }
            else -> emptyList()
        }

    private fun get(tree: JsonElement, path: List<Any>): JsonElement = path.fold(tree) { here, step ->
        if (step is Int) (here as JsonArray)[step] else (here as JsonObject).getValue(step as String)
    }

    /** [tree] with [value] at [path], or without what was there. */
    private fun put(tree: JsonElement, path: List<Any>, value: JsonElement?): JsonElement {
        if (path.isEmpty()) return value ?: JsonNull
        val step = path[0]
        val rest = path.drop(1)
        val isGone = rest.isEmpty() && value == null
        return if (tree is JsonArray) {
            JsonArray(
                tree.flatMapIndexed { k, entry ->
                    if (k != step) {
                        listOf(entry)
                    } else if (isGone) {
                        emptyList()
                    } else {
                        listOf(put(entry, rest, value))
                    }
                },
            )
        } else {
            val fields = tree as JsonObject
            if (isGone) {
                JsonObject(fields - step as String)
            } else {
                JsonObject(fields + (step as String to put(fields.getValue(step), rest, value)))
            }
        }
    }

    private companion object {
        const val MOST_LISTED = 20
        val FRAGMENTS = listOf(
            "", " ", "null", "1", "[]", "{}", "{\"a\":}", "/*", "{//",
            "{\"name\":\"\\u12", "{\"name\":\"\\ud800\"}",
        )
        val KEYS = "x seed type count unknown lengths Name fraction exponent opticalDepth relative".split(" ") + ""
        val NUMBERS = (
            "0 -0.0 1 -1 2 3 7 0.5 -0.5 1e-300 -1e-300 1e300 -1e300 1e-15 1e15 2147483647 2147483648 -2147483648 " +
                "9223372036854775807 9223372036854775808 4.9e-324 1.7976931348623157e308 1e-40 1e40 0.7404 " +
                "0.9999999999999999 1.0000000000000002 1e10 1e-10 1e100 1e-100 1e155 1e-155 " +
                "6 1024 1000000 100000000 1e999"
            ).split(" ")
    }
}
