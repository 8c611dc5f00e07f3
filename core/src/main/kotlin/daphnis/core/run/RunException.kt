package daphnis.core.run

/** A run failed through no fault of the input; the message is one line. */
public class RunException(message: String, cause: Throwable? = null) : RuntimeException(message, cause)
