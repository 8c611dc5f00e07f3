package daphnis.app

import daphnis.core.Repository.read
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.io.File
import java.nio.file.Path
import java.util.zip.ZipFile

/**
 * Runs under either build, so both resolve what the table says: the same versions, and nothing that nobody knows of.
 */
@Tag("jdk-neutral")
class ShippedLibrariesTest {
    /** Version by artifact, from the table. */
    private val listed = read("docs/third-party.md").lines()
        .mapNotNull { Regex("""\| [\w.-]+:([\w.-]+) \| ([\w.-]+) \| (\S.*) \|""").matchEntire(it) }
        .associate { it.groupValues[1] to it.groupValues[2] }

    /**
     * Jars on the class path by artifact and version, from where they lie: …/artifact/version/file.jar, or with a hash
     * between in Gradle's cache. The name of the file may be another.
     */
    private val jars = System.getProperty("java.class.path").split(File.pathSeparator)
        .filter {
            it.endsWith(".jar") &&
                "/target/" !in it &&
                "/build/libs/" !in it &&
                !it.endsWith("/gradle-worker.jar")
        }
        .associateBy {
            val folders = Path.of(it).parent.map(Path::toString)
            val (artifact, version) = folders.filterNot { name -> name.matches(Regex("[0-9a-f]{30,40}")) }.takeLast(2)
            artifact to version
        }
    private val present = jars.keys.toMap()

    @Test
    fun `every library of the table is on the class path in its version`() {
        assertTrue(listed.size > 30, "the table has only ${listed.size} rows")
        assertEquals(listed, present.filterKeys { it in listed })
    }

    @Test
    fun `nothing else is on the class path but what tests need`() {
        assertEquals(emptyList<String>(), present.keys.filter { it !in listed && !it.matches(FOR_TESTS) }.sorted())
    }

    /** Apache-2.0 is the licence of daphnis too, whose text is shipped; MIT-0 asks for nothing. */
    @Test
    fun `the text of every other licence is in its jar or in the table's page`() {
        val page = read("docs/third-party.md")
        val others = page.lines()
            .mapNotNull {
                Regex("""\| [\w.-]+:([\w.-]+) \| ([\w.-]+) \| (?!Apache-2\.0 \|)(?!MIT-0)\S.* \|""").matchEntire(it)
            }
            .map { it.groupValues[1] }
        assertTrue("jcodec" in others && "slf4j-api" in others && "reactive-streams" !in others) { "$others" }
        val without = others.filter { artifact ->
            val isInJar = ZipFile(jars.getValue(artifact to present.getValue(artifact))).use { zip ->
                zip.entries().asSequence().any { it.name.matches(Regex("(?i)(.*/)?(licen[cs]e|copying)[^/]*")) }
            }
            !isInJar && "\n### $artifact\n" !in page
        }
        assertEquals(emptyList<String>(), without)
    }

    private companion object {
        val FOR_TESTS =
            Regex(
                "junit-.*|opentest4j|apiguardian-api|archunit|surefire-.*|maven-surefire-.*|kotlin-test.*|" +
                    "abi-tools.*|kotlin-metadata-jvm|kotlin-klib-abi-reader|java-diff-utils",
            )
    }
}
