package daphnis.app

import daphnis.core.Repository.read
import daphnis.core.engine.EnginesAgreeContract
import daphnis.core.engine.TestedEngines
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Every engine that the command line knows, as it is registered. Their modules draw cases by the hundred. */
class EnginesAgreeTest : EnginesAgreeContract(TestedEngines(allEngines), draws = 6) {
    @Test
    fun `the docs name the engines of the registry`() {
        val table = read("docs/concurrency.md").lines().dropWhile { !it.startsWith("| engine ") }
            .takeWhile { it.startsWith("|") }
        val named = table.drop(2).map { it.split('|')[1].trim().trim('`') }
        assertEquals(allEngines.names.toSet() - "serial", named.toSet()) { "table of docs/concurrency.md" }
        for (page in listOf("README.md", "docs/guide.md", "docs/scenario.md")) {
            val missing = allEngines.names.filter { "`$it`" !in read(page) }
            assertTrue(missing.isEmpty()) { "$page does not name $missing" }
        }
    }
}
