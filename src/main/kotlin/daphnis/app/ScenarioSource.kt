package daphnis.app

import daphnis.core.input.InputException
import daphnis.core.input.Nearest
import daphnis.core.run.atHome
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import java.nio.file.Files

/** The scenario that a word on the command line means: a file if there is one, else a built-in name. */
internal fun scenarioNamed(word: String, settings: List<String>): Scenario = try {
    read(word, settings)
} catch (e: InputException) {
    throw if (settings.any { isList(it, e.key) }) InputException("", null, "${e.message}; $SWEEP_HINT") else e
}

/** Whether [setting] gives [key] several numbers, as only a sweep takes them. */
private fun isList(setting: String, key: String?): Boolean {
    val values = setting.substringAfter('=', "").split(',')
    return setting.substringBefore('=') == key && values.size > 1 && values.all { it.toDoubleOrNull() != null }
}

private const val SWEEP_HINT = "a run for each of several values is `daphnis sweep`"

private fun read(word: String, settings: List<String>): Scenario {
    val path = pathOf(word, "scenario")
    if (word in BuiltIn.names && !Files.isRegularFile(path)) return BuiltIn.scenario(word, settings)
    if (!Files.exists(path)) {
        throw InputException(
            word,
            null,
            "no such file, and no built-in scenario; ${Nearest.question(word, BuiltIn.names)}" +
                "built in are ${BuiltIn.names.joinToString()}",
        )
    }
    if (Files.isDirectory(path)) {
        throw InputException(word, null, "is a directory; a scenario file or a built-in name is needed")
    }
    return ScenarioJson.read(path, settings).atHome(path.toAbsolutePath().parent)
}

/**
 * What the command line changes of the physics is said behind the description, which may no longer hold.
 *
 * @param changes as `path=value`
 */
internal fun Scenario.changedBy(changes: List<String>): Scenario {
    val told = changes.filterNot { it.startsWith("output.") || it.startsWith("engine.") }
    val isOwn = changes.any { it.startsWith("description=") }
    if (description.isEmpty() || told.isEmpty() || isOwn) return this
    return copy(description = "$description; changed: ${told.joinToString(", ")}")
}
