package daphnis.core.format

/** A file does not hold what its format promises. The message is one line that names the file and what is wrong. */
public class FormatException(message: String) : RuntimeException(message)
