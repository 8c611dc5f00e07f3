package daphnis.app.pages

import com.github.ajalt.clikt.completion.CompletionCandidates
import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parsers.CommandInvocation
import com.github.ajalt.clikt.parsers.CommandLineParser
import daphnis.app.allEngines
import daphnis.app.daphnisCommand
import daphnis.app.live.joinedLive
import daphnis.app.pathsLast
import daphnis.app.sweep.SweepPlan
import daphnis.app.understood
import daphnis.core.Repository
import daphnis.core.input.InputException
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import java.nio.file.Files
import kotlin.io.path.extension
import kotlin.io.path.isExecutable
import kotlin.io.path.isRegularFile
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText

/** What is wrong with a command, found without running it: null when nothing is. */
internal class CommandCheck {
    private val root = Repository.root

    /** Names of the classes of tests and of those that have a `main`. */
    private val classes: Set<String> by lazy {
        listOf("core", "actors", "analysis", "bench", "src").flatMap { module ->
            Files.walk(root.resolve(module)).use { files ->
                files.filter { "${it.parent}".contains("src") && it.extension in setOf("kt", "java") }.toList()
            }
        }.map { it.nameWithoutExtension }.toSet()
    }

    fun problem(words: List<String>): String? {
        val program = words.first()
        val file = program.removePrefix("./")
        return when {
            isDaphnis(words) -> daphnisProblem(words.drop(1))
            program in setOf("mvn", "gradle") -> testProblem(words)
            program == "java" -> mainProblem(words)
            program.startsWith("./") || program.startsWith("tools/") || program.startsWith("python/") ->
                toolProblem(file, words.drop(1))
            else -> null
        }
    }

    fun isDaphnis(words: List<String>): Boolean = words.first().removePrefix("./") == "daphnis"

    /** The parser of the program, which reads all values, and then what commands look at themselves. */
    private fun daphnisProblem(words: List<String>): String? {
        val command = daphnisCommand()
        val given = joinedLive(words.toTypedArray())
        return try {
            val ordered = command.pathsLast(command.understood(given)).toList()
            val parsed = CommandLineParser.parseAndRun(command, ordered) {}
            parsed.invocation.subcommandInvocations.singleOrNull()?.let { valueProblem(it) }
        } catch (e: UsageError) {
            command.getFormattedHelp(e).orEmpty().lines().last { it.isNotBlank() }
        } catch (e: CliktError) {
            // What --help and --version answer with.
            if (e.statusCode == 0) null else "${e.message}"
        } catch (e: InputException) {
            e.message
        }
    }

    private fun valueProblem(invocation: CommandInvocation<*>): String? {
        val options = invocation.optionInvocations.entries.associate { (option, given) ->
            option.names.first() to given.flatMap { it.values }
        }
        for ((option, given) in invocation.optionInvocations) {
            val candidates = option.completionCandidates
            val known = (candidates as? CompletionCandidates.Fixed)?.candidates ?: continue
            given.flatMap { it.values }.find { it !in known }?.let { return "${option.names.first()} is $it" }
        }
        options["--engines"].orEmpty().flatMap { it.split(',') }.find { it !in allEngines.names }?.let {
            return "--engines has $it"
        }
        val name = invocation.command.commandName
        if (name !in WITH_SCENARIO) return null
        val scenario = invocation.argumentInvocations.flatMap { it.values }.firstOrNull()
        if (scenario == null && "--collect" in options) return null
        val settings = options["--set"].orEmpty()
        val seeds = options["--seeds"]?.single()
        val all = if (name == "sweep") SweepPlan.of(settings, seeds).runs.map { it.settings } else listOf(settings)
        return all.distinct().firstNotNullOfOrNull { settingsProblem(scenario, it) ?: startProblem(scenario, it) }
    }

    /** Whether a run of a built-in scenario can start with [settings]. */
    private fun startProblem(scenario: String?, settings: List<String>): String? {
        if (scenario == null || scenario !in BuiltIn.names) return null
        return try {
            ScenarioSetup.check(BuiltIn.scenario(scenario, settings), scenario)
            null
        } catch (e: InputException) {
            e.message
        }
    }

    /** [scenario] is a file's name, a built-in one's or null; of a file that is not there all that any takes is right. */
    private fun settingsProblem(scenario: String?, settings: List<String>): String? {
        val isFile = scenario == null || scenario.endsWith(".json") || '/' in scenario || PLACE.matches(scenario)
        val problems = (if (isFile) BuiltIn.names else listOf(scenario)).map { name ->
            try {
                BuiltIn.scenario(name, settings)
                return null
            } catch (e: InputException) {
                "${e.message}"
            }
        }
        return problems.first()
    }

    private fun testProblem(words: List<String>): String? {
        val tests = words.mapNotNull { Regex("-Dtest=(.*)").matchEntire(it)?.groupValues?.get(1) }
            .flatMap { it.split(',') }.map { it.substringBefore('#') }
        return tests.find { it !in classes }?.let { "there is no test $it" }
    }

    private fun mainProblem(words: List<String>): String? =
        words.find { it.startsWith("daphnis.") }?.takeIf { it.substringAfterLast('.').removeSuffix("Kt") !in classes }
            ?.let { "there is no $it" }

    private fun toolProblem(name: String, words: List<String>): String? {
        val file = root.resolve(name)
        if (!file.isRegularFile()) return "$name is not there"
        // Python runs its own, which then need not be.
        if (!file.isExecutable() && !name.endsWith(".py")) return "$name cannot be run"
        val known = OPTION.findAll(file.readText()).map { it.value }.toSet()
        val option = optionsIn(words).find { it !in known }
        return option?.let { "$it is no option of $name" }
    }

    /**
     * The same of code within a line, where a command may be no more than named, an option may belong to any of them,
     * and capitals stand for what a reader puts there.
     */
    fun inlineProblem(code: String): String? {
        if ('…' in code) return null
        val words = shellCommands(code).firstOrNull()?.words ?: return null
        if (isDaphnis(words)) return namedProblem(words.drop(1))
        if (words.first().startsWith("tools/") && !Files.isDirectory(root.resolve(words.first()))) return problem(words)
        if (words.first().startsWith("./")) return problem(words)
        if (!words.first().startsWith("--")) return null
        val unknown = optionsIn(words).find { it !in options }
        return unknown?.let { "$it is no option" } ?: settingsProblem(null, settingsIn(words))
    }

    private fun namedProblem(words: List<String>): String? {
        val name = words.firstOrNull() ?: return null
        if (name.startsWith("-")) return daphnisProblem(words)
        val command = daphnisCommand().registeredSubcommands().find { it.commandName == name }
            ?: return "$name is no command"
        val known = command.registeredOptions().flatMap { it.names } + "--help"
        optionsIn(words).find { it !in known }?.let { return "$it is no option of $name" }
        val scenario = words.getOrNull(1)?.takeIf { name in WITH_SCENARIO && !it.startsWith("-") }
        return settingsProblem(scenario, settingsIn(words))
    }

    private fun optionsIn(words: List<String>) = words.filter { it.startsWith("--") }.map { it.substringBefore('=') }

    private fun settingsIn(words: List<String>) = words.indices.mapNotNull { k ->
        if (words[k].startsWith("--set=")) {
            words[k].substringAfter('=')
        } else {
            words[k].takeIf { words.getOrNull(k - 1) == "--set" }
        }
    }.filter { it != "path=value" && it != "path=value,value" }

    /** Of all commands, of our tools, and of what they are run with. */
    private val options: Set<String> = daphnisCommand().registeredSubcommands()
        .flatMap { command -> command.registeredOptions().flatMap { it.names } }.toSet() +
        daphnisCommand().registeredOptions().flatMap { it.names } +
        listOf("check", "tools/site").flatMap { tool ->
            OPTION.findAll(root.resolve(tool).readText()).map { it.value }.toList()
        } + setOf("--add-modules")

    private companion object {
        val OPTION = Regex("""--[a-z][a-z-]*""")

        val WITH_SCENARIO = setOf("run", "sweep", "describe", "bench")

        /** What stands for a name of the reader's. */
        val PLACE = Regex("[A-Z]+")
    }
}
