package daphnis.app

/**
 * Says a line on the error stream when the process is interrupted before [close].
 *
 * @param words of that line
 */
internal class LastWords(words: () -> String) : AutoCloseable {
    private val hook = Thread { warn(words()) }

    init {
        Runtime.getRuntime().addShutdownHook(hook)
    }

    override fun close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (e: IllegalStateException) {
            // It has been interrupted, and is being said. What else goes wrong because of that is not to be said.
            Thread.currentThread().join()
        }
    }
}
