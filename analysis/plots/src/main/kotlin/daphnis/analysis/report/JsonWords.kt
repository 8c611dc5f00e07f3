package daphnis.analysis.report

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** A part of a scenario for a reader, in the spelling of the scenario's file: `constant, coefficient 0.9`. */
internal object JsonWords {
    private const val MOST = 6
    private const val LONGEST = 20
    private const val DIGITS = 6

    /** In one line; keys that are null are left out. */
    fun text(part: JsonElement): String = when (part) {
        is JsonPrimitive -> word(part)
        is JsonArray -> list(part)
        is JsonObject -> {
            val type = listOfNotNull((part["type"] as? JsonPrimitive)?.content)
            val values = (part - "type").filter { it.value !is JsonNull }
            (type + values.map { (key, value) -> "$key ${inside(value)}" }).joinToString()
        }
    }

    private fun inside(part: JsonElement) = if (part is JsonObject) "(${text(part)})" else text(part)

    private fun list(entries: JsonArray): String {
        if (entries.isEmpty()) return "none"
        if (entries[0] is JsonObject) return entries.joinToString("; ") { text(it) }
        val first = entries.take(MOST).joinToString { text(it) }
        return if (entries.size > MOST) "[$first, …], ${entries.size} of them" else "[$first]"
    }

    /** A number that is long follows from others, and its last digits do not help a reader. */
    private fun word(value: JsonPrimitive): String {
        val number = value.content.toDoubleOrNull()?.takeUnless { value.isString }
        val isShort = value.content.length <= LONGEST && !value.content.contains('e', ignoreCase = true)
        return if (number == null || isShort) value.content else ReportText.plain(number, DIGITS)
    }
}
