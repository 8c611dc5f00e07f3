package daphnis.app.live

import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject

/** How what a page shows has ended, in [words] for its reader. */
internal class Ending(private val kind: Kind, private val words: String) {
    /** As the page is told. */
    fun json(): String = buildJsonObject {
        put("kind", JsonPrimitive(kind.name.lowercase()))
        put("text", JsonPrimitive(words))
    }.toString()

    /** What the page makes of it; [CLOSED] is the end of the server alone. */
    enum class Kind { COMPLETE, INTERRUPTED, FAILED, CLOSED }
}
