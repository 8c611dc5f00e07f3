package daphnis.app

import com.github.ajalt.clikt.completion.CompletionGenerator
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.types.choice
import daphnis.app.printing.printLines

/** `daphnis completion`. */
class CompletionCommand : CliktCommand(name = "completion") {
    private val shell by argument("shell", help = "bash, zsh or fish").choice("bash", "zsh", "fish")

    override fun help(context: Context) = "Print a script with which a shell completes command lines of daphnis."

    override fun run() {
        val script = CompletionGenerator.generateCompletionForCommand(currentContext.findRoot().command, shell)
        // A directory is completed with a slash, and blanks in names are quoted.
        val quoted = script.replace("\ncomplete -F ", "\ncomplete -o filenames -F ")
        printLines(if (shell == "zsh") quoted.replace(REGISTRATION, ZSH_WORDS + REGISTRATION_OF_ZSH) else quoted)
    }

    private companion object {
        const val REGISTRATION = "\ncomplete -o filenames -F _daphnis daphnis"
        const val REGISTRATION_OF_ZSH = "\ncomplete -o filenames -F _daphnis_zsh daphnis"

        /** The script is for words as bash parts them, at equals signs too; zsh has `--engine=h` as one. */
        val ZSH_WORDS = "\n" + """
            _daphnis_zsh() {
                local -a parted
                local k=0 word='' option=''
                parted=()
                while [[ ${'$'}{k} -le ${'$'}COMP_CWORD ]]; do
                    word="${'$'}{COMP_WORDS[${'$'}k]}"
                    option=''
                    case "${'$'}word" in
                        --*=*)
                            option="${'$'}{word%%=*}="
                            parted+=("${'$'}{word%%=*}" "=" "${'$'}{word#*=}")
                            ;;
                        *) parted+=("${'$'}word") ;;
                    esac
                    (( k = k + 1 ))
                done
                COMP_WORDS=("${'$'}{parted[@]}")
                COMP_CWORD=${'$'}(( ${'$'}{#parted[@]} - 1 ))
                _daphnis
                if [[ -n "${'$'}option" ]]; then COMPREPLY=("${'$'}{COMPREPLY[@]/#/${'$'}option}"); fi
            }
        """.trimIndent() + "\n"
    }
}
