package daphnis.app.sweep

import java.util.Locale
import java.util.zip.CRC32

/**
 * Names for the directories of runs: `opticalDepth=0.1,seed=3`. A key goes by the last part of its path where that is
 * clear. Characters that a shell or a file system may take amiss become `-`; values that so become alike are numbered.
 */
internal class RunNames(private val keys: List<SweptKey>) {
    private val short: List<String> = run {
        val last = keys.map { it.path.substringAfterLast('.') }
        keys.indices.map { k ->
            val isClear = last.count { it.equals(last[k], ignoreCase = true) } == 1 && '[' !in keys[k].path
            safe(if (isClear) last[k] else keys[k].path)
        }
    }
    private val values: List<Map<String, String>> = keys.map { key ->
        val taken = HashSet<String>()
        key.values.associateWith { value ->
            val base = safe(value).ifEmpty { "empty" }
            val numbered = generateSequence(2) { it + 1 }.map { "$base-$it" }
            (sequenceOf(base) + numbered).first { taken.add(it.lowercase()) }
        }
    }

    /** The name of the run with [own] values of the keys. */
    fun of(own: List<String>, seed: Long?): String {
        val parts = keys.indices.map { "${short[it]}=${values[it].getValue(own[it])}" } + listOfNotNull(
            seed?.let { "seed=$it" },
        )
        val name = parts.joinToString(",")
        if (name.length <= MOST) return name
        // What is cut off may be all in which two runs differ.
        val sum = CRC32().apply { update(name.toByteArray()) }.value
        val tail = String.format(Locale.ROOT, ",%08x", sum) + seed?.let { ",seed=$it" }.orEmpty()
        return name.take(MOST - tail.length) + tail
    }

    private fun safe(text: String): String =
        text.map { if (it in PLAIN) it else '-' }.joinToString("").replace(Regex("-{2,}"), "-").let {
            if (text.toDoubleOrNull() != null) it else it.trim('-')
        }.take(LONGEST)

    private companion object {
        val PLAIN = ('a'..'z') + ('A'..'Z') + ('0'..'9') + listOf('.', '_', '-', '+')

        /** Of a part. */
        const val LONGEST = 32

        /** Of a name: what file systems allow. */
        const val MOST = 255
    }
}
