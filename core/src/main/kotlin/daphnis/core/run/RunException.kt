package daphnis.core.run

import daphnis.core.input.oneLine

/** Thrown when a run failed and the input is not the cause; the message is one line. */
public class RunException @JvmOverloads constructor(message: String, cause: Throwable? = null) :
    RuntimeException(oneLine(message), cause)
