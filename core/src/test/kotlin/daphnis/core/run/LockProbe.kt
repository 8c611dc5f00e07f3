package daphnis.core.run

import daphnis.core.input.InputException
import java.nio.file.Path
import kotlin.system.exitProcess

/** Another process that tries to take the lock of a run directory. */
object LockProbe {
    @JvmStatic
    fun main(args: Array<String>) {
        try {
            RunLock.take(Path.of(args[0])).close()
        } catch (e: InputException) {
            exitProcess(if ("another process" in e.message.orEmpty()) 3 else 1)
        }
    }
}
