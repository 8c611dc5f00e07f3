package daphnis.core.input

/**
 * Thrown when the input is wrong. [message] is one line that names the source, the key, the value and what would be
 * right. Control characters in these, on which a terminal would act, are replaced.
 *
 * @property source file or built-in that has the key, or the argument of the call
 * @property key dotted path, or null when the whole file is meant
 * @property wayOut what the caller can do about it with other arguments; null when the message is complete
 * @property isArgument whether [source] is an argument of the call, for which a caller may have another name
 */
public class InputException @JvmOverloads constructor(
    public val source: String,
    public val key: String?,
    private val problem: String,
    public val wayOut: WayOut? = null,
    public val isArgument: Boolean = false,
) : RuntimeException(line(source, key, problem, wayOut?.words)) {
    /**
     * [message] for users who have other names for [source] and [wayOut], such as the flags of a command line.
     *
     * @param wayOut the other name of [wayOut], as a part of the sentence
     */
    public fun message(source: String, wayOut: String?): String = line(source, key, problem, wayOut)
}

private fun line(source: String, key: String?, problem: String, wayOut: String?): String {
    val said = problem.lineSequence().joinToString(" ") { it.trim() }
    val whole = if (wayOut == null) said else "$said; $wayOut"
    return oneLine(listOfNotNull(source.ifEmpty { null }, key, whole).joinToString(": "))
}

/** The exception for wrong input that came as the [argument] of a call. */
internal fun wrongArgument(argument: String, key: String?, problem: String): InputException =
    InputException(argument, key, problem, isArgument = true)
