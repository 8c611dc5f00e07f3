package daphnis.core.scenario

import daphnis.core.format.oneLine

/**
 * The input is wrong. [message] is one line that names the source, the key, the value and what would be right;
 * characters in these that a terminal would obey are replaced.
 *
 * @property source file or built-in the key stands in, or the argument of the call
 * @property key dotted path, or null when the whole file is meant
 * @property wayOut what the caller can do about it with other arguments; null when the message says all
 * @property isArgument whether [source] is an argument of the call, which a caller may know by another name
 */
public class InputException(
    public val source: String,
    public val key: String?,
    private val problem: String,
    public val wayOut: WayOut? = null,
    public val isArgument: Boolean = false,
) : RuntimeException(line(source, key, problem, wayOut?.words)) {
    /**
     * [message] for users who call [source] and [wayOut] by other names, as a command line calls its flags.
     *
     * @param wayOut likewise as a part of the sentence
     */
    public fun message(source: String, wayOut: String?): String = line(source, key, problem, wayOut)
}

private fun line(source: String, key: String?, problem: String, wayOut: String?): String {
    val said = problem.lineSequence().joinToString(" ") { it.trim() }
    val whole = if (wayOut == null) said else "$said; $wayOut"
    return oneLine(listOfNotNull(source.ifEmpty { null }, key, whole).joinToString(": "))
}

/** The input is wrong that came as the [argument] of a call. */
internal fun wrongArgument(argument: String, key: String?, problem: String): InputException =
    InputException(argument, key, problem, isArgument = true)
