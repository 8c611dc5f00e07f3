package daphnis.app

import com.github.ajalt.clikt.core.BaseCliktCommand
import com.github.ajalt.clikt.core.CliktCommand

/**
 * The [words] of a command line, with paths moved behind the options if one of them would be taken for an option: to
 * the library `/runs/seed=1` is the option `/runs/seed` with a value, as on some systems.
 */
internal fun CliktCommand.pathsLast(words: Array<String>): Array<String> {
    val command = registeredSubcommands().find { it.commandName == words.firstOrNull() } ?: return words
    if (words.none { looksLikeOption(it) }) return words
    val options = ArrayList<String>()
    val paths = ArrayList<String>()
    var k = 1
    while (k < words.size) {
        val word = words[k++]
        if (word == END) {
            while (k < words.size) paths += words[k++]
        } else if (word.startsWith("-") && word.length > 1) {
            options += word
            if (command.takesNext(word) && k < words.size) options += words[k++]
        } else {
            paths += word
        }
    }
    return arrayOf(words[0], *options.toTypedArray(), END, *paths.toTypedArray())
}

private fun looksLikeOption(word: String): Boolean =
    word.isNotEmpty() && !word[0].isLetterOrDigit() && word[0] != '-' && '=' in word

/** Whether the word after [option] is its value. */
private fun BaseCliktCommand<*>.takesNext(option: String): Boolean =
    registeredOptions().any { (option in it.names || option in it.secondaryNames) && it.nvalues.first > 0 }

private const val END = "--"
