package daphnis.app

import daphnis.core.run.atHome
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.InputException
import daphnis.core.scenario.Nearest
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import java.nio.file.Files

/** The scenario that a word on the command line means: a file if there is one, else a built-in name. */
internal fun scenarioNamed(word: String, settings: List<String>): Scenario {
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
