package daphnis.app

import daphnis.actors.ActorEngines
import daphnis.analysis.insitu.State
import daphnis.analysis.report.Analysis
import daphnis.core.Repository
import daphnis.core.Simulation
import daphnis.core.api.EngineApi
import org.jetbrains.kotlin.abi.tools.AbiFilters
import org.jetbrains.kotlin.abi.tools.AbiTools
import org.jetbrains.kotlin.abi.tools.AbiToolsFactory
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.util.ServiceLoader

/**
 * What programs are compiled against is written down, a file for each library, and changes on purpose only. Runs under
 * either build, so both make the same. [REWRITE] writes the files anew.
 */
@Tag("jdk-neutral")
class PublicApiTest {
    @TempDir
    lateinit var home: Path

    private val tools: AbiTools = ServiceLoader.load(AbiToolsFactory::class.java).first().get()

    /** A class of each library by the file of its API. */
    private val libraries = mapOf(
        "core/api/core.api" to Simulation::class.java,
        "actors/api/actors.api" to ActorEngines::class.java,
        "analysis/api/analysis.api" to State::class.java,
        "analysis/plots/api/plots.api" to Analysis::class.java,
    )

    /** Everything public in what [type] was loaded from, a jar or a folder of classes, but for engines' own. */
    private fun dump(type: Class<*>): String {
        val place = File(type.protectionDomain.codeSource.location.toURI())
        val files = if (place.isDirectory) place.walk().filter { it.extension == "class" }.toList() else listOf(place)
        val engines = setOf(EngineApi::class.java.name)
        return StringBuilder().also { tools.printJvmDump(it, files, AbiFilters(NONE, NONE, NONE, engines)) }.toString()
    }

    /** Lines of [now] which the file [written] lacks, and the reverse; empty when they are the same. */
    private fun difference(written: Path, now: String): String {
        val file = Files.writeString(home.resolve("now.api"), now)
        return tools.filesDiff(written.toFile(), file.toFile()).orEmpty()
    }

    @Test
    fun `the public API of every library is the one that is written down`() {
        for ((path, type) in libraries) {
            val file = Repository.root.resolve(path)
            if (System.getProperty("daphnis.api") == "write") Files.writeString(file, dump(type))
            val found = difference(file, dump(type))
            assertEquals("", found) { "$path: the API has changed; where that is meant: $REWRITE\n$found" }
        }
    }

    @Test
    fun `what is taken away and what is added is told`() {
        val (path, type) = libraries.entries.first()
        val lines = dump(type).lines()
        val gone = lines.first { "fun advance ()" in it }
        val found = difference(Repository.root.resolve(path), (lines - gone + "added").joinToString("\n"))
        assertTrue("-$gone" in found && "+added" in found) { found }
    }

    @Test
    fun `what only engines need is no part of it`() {
        val core = Repository.read("core/api/core.api")
        assertTrue("class daphnis/core/engine/SerialEngine " in core)
        assertFalse("daphnis/core/collision/StepRows " in core.lines().filter { " class " in it }.joinToString("\n"))
    }

    private companion object {
        val NONE = emptySet<String>()
        const val REWRITE = "mvn -pl src -am test -Dtest=PublicApiTest -Dsurefire.failIfNoSpecifiedTests=false " +
            "-Ddaphnis.api=write, or gradle test --tests daphnis.app.PublicApiTest -Papi=write"
    }
}
