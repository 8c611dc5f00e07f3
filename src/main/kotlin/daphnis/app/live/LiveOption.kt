package daphnis.app.live

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.optionalValue
import com.github.ajalt.clikt.parameters.types.int
import daphnis.app.printing.printLine
import daphnis.core.input.InputException

/** The option of commands that can be looked at while they run. */
internal class LiveOption : OptionGroup() {
    private val live by option(
        LIVE,
        metavar = "port",
        help = "serve a page on this machine that shows the run as it goes on (default: any free port)",
    ).int().optionalValue(ANY_PORT, acceptsUnattachedValue = false)

    /**
     * Does [act] with the page, or with null when none is asked for.
     *
     * @throws InputException when it cannot be served
     */
    fun <T> withPage(act: (LivePage?) -> T): T {
        val port = live ?: return act(null)
        requirePort(LIVE, port)
        return LivePage(port).use { page ->
            printLine("live: ${page.address}")
            act(page)
        }
    }
}

/** @throws InputException when [port], of [option], is none */
internal fun requirePort(option: String, port: Int) {
    if (port !in 0..MOST_PORT) throw InputException(option, null, "is $port; a port is in 0..$MOST_PORT, 0 for any")
}

/** [words] with the number that follows the option joined to it: any other word after it is the scenario. */
internal fun joinedLive(words: Array<String>): Array<String> {
    val joined = ArrayList<String>()
    for (word in words) {
        if (joined.lastOrNull() == LIVE &&
            word.matches(Regex("-?[0-9]+"))
        ) {
            joined[joined.lastIndex] = "$LIVE=$word"
        } else {
            joined += word
        }
    }
    return joined.toTypedArray()
}

private const val LIVE = "--live"
private const val ANY_PORT = 0
private const val MOST_PORT = 65_535
