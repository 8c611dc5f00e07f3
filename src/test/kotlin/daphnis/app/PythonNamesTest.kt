package daphnis.app

import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.nio.file.Files
import kotlin.io.path.extension
import kotlin.io.path.readText
import kotlin.streams.asSequence

/** What Python names is there, also where there is no Python to try it. */
@Tag("jdk-neutral")
class PythonNamesTest {
    @Test
    fun `every class that the Python package names is there`() {
        val sources = Files.walk(Repository.root.resolve("python/src")).use { files ->
            files.asSequence().filter { it.extension == "py" }.map { it.readText() }.toList()
        }
        val names = sources.flatMap { text -> NAME.findAll(text).map { it.groupValues[1] } }.toSortedSet()
        assertTrue(names.size > 20) { "$names" }
        assertEquals(emptyList<String>(), names.filter { runCatching { Class.forName(it) }.isFailure })
    }

    @Test
    fun `what it takes from classes that Kotlin makes of functions and objects is there`() {
        val members = listOf(
            "daphnis.core.Engines" to "factory",
            "daphnis.actors.ActorEngines" to "factory",
            "daphnis.core.run.ScenarioEngine" to "of",
            "daphnis.core.scenario.Warnings" to "of",
            "daphnis.core.population.GranularTemperature" to "of",
            "daphnis.core.population.Digest" to "stateDigest",
        )
        val missing = members.filter { (name, member) -> Class.forName(name).methods.none { it.name == member } }
        assertEquals(emptyList<Pair<String, String>>(), missing)
    }

    private companion object {
        val NAME = Regex(""""(daphnis\.[a-z.]+\.[A-Z][A-Za-z]*)"""")
    }
}
