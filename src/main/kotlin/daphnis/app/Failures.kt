package daphnis.app

import daphnis.app.printing.reasonInWords
import daphnis.app.printing.warn
import daphnis.core.format.FormatException
import daphnis.core.input.InputException
import java.nio.file.InvalidPathException

/** Says in one line on the error stream what went wrong. @return the exit code for it */
internal fun complain(e: Throwable): Int = when (e) {
    is InputException, is FormatException, is InvalidPathException -> complain(reasonInWords(e), EXIT_INPUT)
    else -> complain(reasonInWords(e), EXIT_FAILED)
}

/** [warn]. @return [code] */
internal fun complain(message: String, code: Int): Int {
    warn(message)
    return code
}
