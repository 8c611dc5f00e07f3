package daphnis.app

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.options.OptionDelegate
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.validate
import com.github.ajalt.clikt.parameters.types.int
import daphnis.core.input.InputException
import daphnis.core.parallel.ThreadHandler

/** `--threads`, a number of threads, or null where it is left out. */
internal fun ParameterHolder.threadsOption(help: String): OptionDelegate<Int?> =
    option("--threads", help = help).int().validate { requireThreads(it) }

/**
 * Refuses what is no number of threads, in the same words for every command. Zero is none, unlike in scenario files:
 * it is more often a variable that went wrong than the wish for one per core, which needs no option.
 *
 * @throws InputException naming the option
 */
internal fun requireThreads(threads: Int) {
    if (threads in 1..ThreadHandler.MOST) return
    val mend = if (threads == 0) "; leave it out for one per core" else ""
    throw InputException("--threads", null, "is $threads; it must be in 1..${ThreadHandler.MOST}$mend")
}
