package daphnis.core.format

/**
 * A file does not hold what its format promises. The message is one line that names the file and what is wrong;
 * characters of a file or its name that a terminal would obey are replaced.
 */
public class FormatException(message: String) : RuntimeException(oneLine(message))

/** [text] with line ends, other control characters and marks that turn the direction of writing replaced. */
internal fun oneLine(text: String): String = text.replace(OBEYED, "?")

private val OBEYED = Regex("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]")
