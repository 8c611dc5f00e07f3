package daphnis.app

import daphnis.core.Repository
import daphnis.core.Repository.read
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.nio.file.Files
import kotlin.io.path.name
import kotlin.io.path.readText

/** What module-info.java of every library says is what is there. Both builds compile it. */
@Tag("jdk-neutral")
class ModulesTest {
    /** A library in [folder], whose API is written down in [api]. */
    private class Library(val folder: String, val api: String) {
        val info = read("$folder/src/main/module/module-info.java")
        val exported = Regex("""(?m)^ +exports ([\w.]+);""").findAll(info).map { it.groupValues[1] }.toList()

        /** Packages that have a public class. */
        val public = Regex("""(?m)^\w.* (?:class|interface) ([\w/]+)/""").findAll(read(api))
            .map { it.groupValues[1].replace('/', '.') }.distinct().sorted().toList()

        /** Sources and resources by the package in which they are. */
        val packages = listOf("kotlin", "java", "resources")
            .map { Repository.root.resolve("$folder/src/main/$it") }.filter(Files::exists)
            .flatMap { root ->
                Files.walk(root).use { all -> all.filter(Files::isRegularFile).toList() }
                    .map { root.relativize(it.parent).joinToString(".") }
            }
            .filter { it.isNotEmpty() }.toSet()

        val sources = Files.walk(Repository.root.resolve("$folder/src/main/kotlin")).use { all ->
            all.filter { it.name.endsWith(".kt") }.toList()
        }.map { it.readText() }
    }

    private val libraries = listOf(
        Library("core", "core/api/core.api"),
        Library("actors", "actors/api/actors.api"),
        Library("analysis", "analysis/api/analysis.api"),
        Library("analysis/plots", "analysis/plots/api/plots.api"),
    )

    @Test
    fun `a module exports the packages of its API, in the order of names, and no others`() {
        for (library in libraries) {
            assertTrue(library.public.size >= 4) { "${library.public}" }
            assertEquals(library.public.joinToString("\n"), library.exported.joinToString("\n")) { library.folder }
        }
    }

    /** Folders of resources are packages of a module too. */
    @Test
    fun `no package is in two modules`() {
        val all = libraries.flatMap { it.packages }
        assertTrue("daphnis.scenarios" in all && "daphnis.cluster.wire" in all)
        assertEquals(emptyList<String>(), all.groupingBy { it }.eachCount().filterValues { it > 1 }.keys.toList())
    }

    @Test
    fun `a module says which services it uses, and opens to Pekko what Pekko makes by name`() {
        val service = Regex("""ServiceLoader\.load\((\w+)::class""")
        for (library in libraries) {
            val used = library.sources.flatMap { service.findAll(it) }.map { it.groupValues[1] }.toSet()
            val said = Regex("""(?m)^ +uses [\w.]*\.(\w+);""").findAll(library.info).map { it.groupValues[1] }.toSet()
            assertEquals(used, said) { library.folder }
        }
        val made = Regex("""(?m)^ *(?:serializers\.daphnis|downing-provider-class) = "([\w.]+)\.\w+"""")
            .findAll(read("actors/src/main/resources/daphnis/cluster/cluster.conf")).map { it.groupValues[1] }.toList()
        assertEquals(2, made.size)
        for (name in made) assertTrue("\n    opens $name to pekko.actor;" in libraries[1].info) { name }
    }
}
