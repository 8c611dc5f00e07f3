package daphnis.core.format

import daphnis.core.input.oneLine

/**
 * Thrown when a file does not agree with its format. The message is one line that names the file and what is wrong.
 * Control characters of a file or its name, on which a terminal would act, are written out.
 */
public class FormatException(message: String) : RuntimeException(oneLine(message))
