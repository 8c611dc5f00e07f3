package daphnis.core.run

/** Thrown when a run failed and the input is not the cause; the message is one line. */
public class RunException @JvmOverloads constructor(message: String, cause: Throwable? = null) :
    RuntimeException(message, cause)
