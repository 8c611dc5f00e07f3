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
            ShellType.BASH -> "COMPREPLY=(\$(compgen -W '$names' -- \"\$word\") \$(compgen -f -- \"\$word\"))"
            ShellType.FISH -> "\"$names (__fish_complete_path)\""
        }
    }

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
