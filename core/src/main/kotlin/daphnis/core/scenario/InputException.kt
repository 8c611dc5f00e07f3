package daphnis.core.scenario

import daphnis.core.format.oneLine

/**
 * The input is wrong. [message] is one line that names the source, the key, the value and what would be right;
 * characters in these that a terminal would obey are replaced.
 *
 * @property source file or built-in the key stands in
 * @property key dotted path, or null when the whole file is meant
 */
public class InputException(public val source: String, public val key: String?, problem: String) :
    RuntimeException(
        oneLine(
            listOfNotNull(source.ifEmpty { null }, key, problem.lineSequence().joinToString(" ") { it.trim() })
                .joinToString(": "),
        ),
    )
