package daphnis.app

import com.github.ajalt.clikt.completion.CompletionCandidates
import com.github.ajalt.clikt.completion.CompletionCandidates.Custom.ShellType
import daphnis.core.scenario.BuiltIn

/** What a shell offers for words of a command line, from what the program itself knows. */
internal object Candidates {
    val files = CompletionCandidates.Path
    val builtIn = CompletionCandidates.Fixed(BuiltIn.names.toSet())
    val engine = CompletionCandidates.Fixed(allEngines.names.toSet())

    /** A scenario is a built-in name or a file. */
    val scenario = CompletionCandidates.Custom { shell ->
        val names = BuiltIn.names.joinToString(" ")
        when (shell) {
            ShellType.BASH ->
                "__complete_files \"\$word\"\n" +
                    "COMPREPLY+=(\$(compgen -W '$names' -- \"\$word\"))"
            ShellType.FISH -> "\"$names (__fish_complete_path)\""
        }
    }

    /** A key of a scenario and its value; the words are in the script once, see [CompletionCommand]. */
    val setting = CompletionCandidates.Custom { shell ->
        when (shell) {
            ShellType.BASH -> SETTINGS
            ShellType.FISH -> SettingWords.all.joinToString(" ", "\"", "\"")
        }
    }

    /** The function of the script that offers settings. */
    const val SETTINGS = "__daphnis_settings"

    /** Engines with commas between; fish completes the first. */
    val engines = CompletionCandidates.Custom { shell ->
        val names = allEngines.names.joinToString(" ")
        when (shell) {
            ShellType.BASH ->
                "local last=\"\${word##*,}\"\n" +
                    "COMPREPLY=(\$(compgen -P \"\${word%\"\$last\"}\" -W '$names' -- \"\$last\"))"
            ShellType.FISH -> "\"$names\""
        }
    }
}
