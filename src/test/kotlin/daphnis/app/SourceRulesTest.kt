package daphnis.app

import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText

/** Rules for the sources of the program. Exceptions are named here until they are fixed; none may be left over. */
@Tag("jdk-neutral")
class SourceRulesTest {
    private val modules = listOf("core", "actors", "analysis", "analysis/plots")

    private fun sources(folder: String): List<Path> {
        val files = Files.walk(Repository.root.resolve(folder)).use { paths ->
            paths.filter { it.extension == "kt" }.sorted().toList()
        }
        assertTrue(files.isNotEmpty()) { "no sources in $folder" }
        return files
    }

    @Test
    fun `no file is longer than 300 lines`() {
        val files = (modules.map { "$it/src/main/kotlin" } + "src/main/kotlin").flatMap(::sources)
        assertEquals(emptyList<String>(), files.filter { it.readLines().size > 300 }.map { it.name })
    }

    @Test
    fun `only the command line names its flags`() {
        // A property of a style sheet has a colon behind it, or var( before it.
        val flag = Regex(""""[^"]*(?<![-\w])(?<!var\()--[a-z][a-z-]*+(?!:)""")
        val naming = modules.flatMap { sources("$it/src/main/kotlin") }
            .filter { file -> file.readLines().any { flag.containsMatchIn(it) } }
            .map { it.name }.toSet()
        assertEquals(FLAGS, naming) { "files of the libraries that name a flag of the command line" }
        assertTrue(sources("src/main/kotlin").any { file -> file.readLines().any { flag.containsMatchIn(it) } })
    }

    /**
     * What others ask of an ingredient of a scenario it says itself, see docs/internals/adding.md, so that the next one is known
     * everywhere. Its own file may compare it with others.
     */
    @Test
    fun `nobody asks of what kind an ingredient is`() {
        val asks = Regex("""(?:\b(?:!?is|as\??)\s+|filterIsInstance<)((?:\w+\.)*?(\w+Spec)\b)""")
        val asking = (modules.map { "$it/src/main/kotlin" } + "src/main/kotlin").flatMap(::sources).flatMap { file ->
            val lines = file.readLines().filterNot { it.trimStart().startsWith("*") || it.trimStart().startsWith("/") }
            val own = lines.mapNotNull { Regex("""(?:class|interface) (\w+Spec)\b""").find(it)?.groupValues?.get(1) }
            lines.flatMap { asks.findAll(it.substringBefore(" // ")) }.map { it.groupValues[2] }.filter { it !in own }
                .map { "${file.name}: $it" }
        }
        assertEquals(emptyList<String>(), asking)
        assertTrue(asks.containsMatchIn("is ForceSpec.Drag ->") && asks.containsMatchIn("as? WallSpec"))
    }

    /** See "What goes away" in docs/releasing.md. */
    @Test
    fun `what is deprecated says since when, and what to call instead`() {
        val folders = modules.flatMap { m -> listOf("$m/src/main/kotlin", "$m/src/main/java") } + "src/main/kotlin"
        val files = folders.filter { Files.exists(Repository.root.resolve(it)) }.flatMap { folder ->
            Files.walk(Repository.root.resolve(folder)).use { it.filter { f -> f.extension in KINDS }.toList() }
        }
        val wrong = files.flatMap { file -> badlyDeprecated(file.readText()).map { "${file.name}: $it" } }
        assertEquals(emptyList<String>(), wrong)
        val right = """@Deprecated("Since 0.3: has no unit.", ReplaceWith("speed(t)"))"""
        assertEquals(emptyList<String>(), badlyDeprecated("$right\nfun a() {}"))
        val slips = mapOf("Since 0.3: " to "", "0.3" to "soon", "ReplaceWith" to "level", "speed(t)" to "")
        for ((part, other) in slips) {
            val slip = "/** Old. */\n    ${right.replace(part, other)}"
            assertEquals(1, badlyDeprecated(slip).size) { slip }
        }
        assertEquals(1, badlyDeprecated("@java.lang.Deprecated void a() {}").size)
    }

    private fun badlyDeprecated(text: String): List<String> {
        val right = Regex("""@Deprecated\(\s*"Since \d+\.\d+: [^"]+"(?:\s*\+\s*"[^"]*")*,\s*ReplaceWith\("[^"]+"""")
        return Regex("""@(?:java\.lang\.)?Deprecated\b""").findAll(text).map { it.range.first }
            .filter { right.matchAt(text, it) == null }.map { text.substring(it).lines().first() }.toList()
    }

    @Test
    fun `no line of prose is longer than 120 characters`() {
        val folders = listOf("docs", "docs/reference", "docs/adr").map { Repository.root.resolve(it) }
        val pages = folders.flatMap { folder ->
            Files.list(folder).use { it.filter { f -> f.extension == "md" }.toList() }
        }
        val long = (pages + listOf("README.md", "CHANGELOG.md").map { Repository.root.resolve(it) }).flatMap { page ->
            var isCode = false
            page.readLines().withIndex().filter { (_, line) ->
                if (line.startsWith("```")) isCode = !isCode
                // Tables and links can't be broken.
                !isCode && line.length > 120 && !line.trimStart().startsWith("|") && "](" !in line && "http" !in line
            }.map { (k, _) -> "${page.name}:${k + 1}" }
        }
        assertEquals(emptyList<String>(), long)
    }

    /** What a terminal obeys goes out by no other way than the one that escapes it. */
    @Test
    fun `only one file writes to the standard streams`() {
        val prints =
            Regex("""(?<![\w.])(?:println|print|echo)\(|::print(?:ln)?\b|\bprintStackTrace\(|\bSystem\.(?:out|err)\b""")
        val printing = (modules.map { "$it/src/main/kotlin" } + "src/main/kotlin").flatMap(::sources).filter { file ->
            file.readLines().filterNot { it.trimStart().startsWith("*") }.any { prints.containsMatchIn(it) }
        }
        // The other puts its own stream in the place of the usual one.
        assertEquals(setOf("Printing.kt", "StandardOutput.kt"), printing.map { it.name }.toSet())
    }

    /**
     * A step that ran out of memory may be done again, so a table of several arrays must not think that it has room
     * for what only some of them have room for.
     */
    @Test
    fun `the array whose length says how much room there is grows last`() {
        val compared = Regex("""(?:[<>=!]=|[<>]) (?:this\.)?(\w+)\.size\b|\b(\w+)\.size (?:[<>=!]=|[<>]) """)
        val assigned = Regex("""^\s+(?:this\.)?(\w+) = .*(?:Array(?:<.*>)?\(|arrayOfNulls|copyOf)""")
        var groups = 0
        val wrong = modules.flatMap { sources("$it/src/main/kotlin") }.flatMap { file ->
            val lines = file.readLines().filterNot { it.trimStart().startsWith("//") }
            val capacities = lines.flatMap { line ->
                compared.findAll(line).map { it.groupValues.last(String::isNotEmpty) }
            }
            val names = lines.map { assigned.find(it)?.groupValues?.get(1) }
            // Stretches of lines that assign one array after another.
            val ends = names.indices.filter { names[it] != null && names.getOrNull(it + 1) == null }
            ends.map { end -> (end downTo 0).takeWhile { names[it] != null }.map { names[it]!! }.distinct() }
                .filter { stretch -> stretch.size > 1 && stretch.any { it in capacities } }
                .onEach { groups++ }
                .filter { it.first() !in capacities }
                .map { "${file.name}: ${it.reversed()}" }
        }
        assertEquals(emptyList<String>(), wrong)
        assertTrue(groups > 15) { "only $groups seen" }
    }

    /** There is one class that knows in which order they may. */
    @Test
    fun `several arrays of an engine that keep what they hold grow only in a growing table`() {
        val grows = Regex("""^\s+(\w+) = \1\.copyOf\(""")
        val starts = Regex("""^\s+(?:\w+ )*fun (\w+)""")
        var tables = 0
        val wrong = listOf("core", "actors").flatMap { sources("$it/src/main/kotlin") }.flatMap { file ->
            val lines = file.readLines()
            val growing = lines.indices.filter { grows.containsMatchIn(lines[it]) }.toSet()
            growing.filter { it - 1 in growing }.filter { k ->
                val function = (k downTo 0).firstNotNullOf { starts.find(lines[it])?.groupValues?.get(1) }
                if (function == "resize") tables++
                function != "resize"
            }.map { "${file.name}:${it + 1}" }
        }
        assertEquals(emptyList<String>(), wrong)
        assertTrue(tables > 20) { "only $tables seen" }
    }

    private companion object {
        val KINDS = setOf("kt", "java")

        /** A report says how to make the run again, or one with more states, and from when on to average. */
        val FLAGS = setOf("RunSection.kt", "SteadinessText.kt")
    }
}
