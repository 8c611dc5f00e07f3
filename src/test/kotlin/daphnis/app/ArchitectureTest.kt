package daphnis.app

import com.tngtech.archunit.ArchConfiguration
import com.tngtech.archunit.base.DescribedPredicate
import com.tngtech.archunit.core.domain.JavaClass
import com.tngtech.archunit.core.domain.JavaClasses
import com.tngtech.archunit.core.importer.ClassFileImporter
import com.tngtech.archunit.core.importer.ImportOption
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.util.function.Function

/**
 * Modules know what the design allows, and no packages know one another in a circle. A rule that finds no class to
 * look at fails.
 */
@Tag("jdk-neutral")
class ArchitectureTest {
    private fun know(packages: String, vararg none: String, of: JavaClasses = classes) =
        noClasses().that().resideInAPackage(packages).should().dependOnClassesThat().resideInAnyPackage(*none).check(of)

    @Test
    fun `every module is there to be looked at, without its tests`() {
        for (name in listOf(
            "core",
            "actors.region",
            "actors.coroutine",
            "actors.pekko",
            "cluster.link",
            "analysis.report",
            "app",
        )) {
            assertTrue(classes.any { it.packageName == "daphnis.$name" }) { "no class of daphnis.$name" }
        }
        assertTrue(classes.none { it.name == "daphnis.core.Sphere" || it.simpleName.endsWith("Test") })
    }

    @Test
    fun `a rule with nothing to look at fails`() {
        val core = classes.that(
            object : DescribedPredicate<JavaClass>("of core") {
                override fun test(c: JavaClass) = c.packageName.startsWith("daphnis.core")
            },
        )
        assertThrows(AssertionError::class.java) { know("daphnis.actors..", "daphnis.analysis..", of = core) }
    }

    @Test
    fun `core knows no other module, no coroutines, no Pekko, no plots`() = know(
        "daphnis.core..",
        "daphnis.actors..",
        "daphnis.analysis..",
        "daphnis.app..",
        "daphnis.bench..",
        "kotlinx.coroutines..",
        "org.apache.pekko..",
        "com.github.ajalt..",
    )

    @Test
    fun `actors and analysis know core and not one another or the command line`() {
        know("daphnis.actors..", "daphnis.analysis..", "daphnis.app..", "com.github.ajalt..")
        know("daphnis.analysis..", "daphnis.actors..", "daphnis.app..", "com.github.ajalt..")
    }

    @Test
    fun `coroutine code and Pekko code know nothing of each other, and what both drive knows neither`() {
        know("daphnis.actors.coroutine..", "org.apache.pekko..", "daphnis.actors.pekko..")
        know("daphnis.actors.pekko..", "kotlinx.coroutines..", "daphnis.actors.coroutine..")
        know(
            "daphnis.actors.region..",
            "kotlinx.coroutines..",
            "org.apache.pekko..",
            "daphnis.actors.coroutine..",
            "daphnis.actors.pekko..",
        )
    }

    @Test
    fun `the cluster knows core alone, and Pekko where it must`() {
        know("daphnis.cluster..", "daphnis.actors..", "daphnis.analysis..", "daphnis.app..", "kotlinx.coroutines..")
        for (part in listOf("hosts", "security", "link", "desk", "settings", "local")) {
            know("daphnis.cluster.$part..", "org.apache.pekko..")
        }
    }

    @Test
    fun `what engines are made of knows no engine`() {
        val parts = listOf("search", "queue", "boundary", "collision", "step")
        for (part in parts) know("daphnis.core.$part..", "daphnis.core.engine..")
    }

    @Test
    fun `an engine knows no other than the serial one`() {
        know("daphnis.core.engine.islands..", "daphnis.core.engine.threadpool..")
        know("daphnis.core.engine.threadpool..", "daphnis.core.engine.islands..")
    }

    @Test
    fun `a simulation knows nothing of files, scenarios and runs`() {
        for (part in listOf("engine", "collision", "search", "queue", "boundary", "force", "population", "hill")) {
            know("daphnis.core.$part..", "daphnis.core.run..", "daphnis.core.scenario..", "daphnis.core.format..")
        }
    }

    @Test
    fun `packages know one another without circles`() {
        slices().matching("daphnis.(**)").should().beFreeOfCycles().check(classes)
    }

    private companion object {
        // Read once for all tests: it takes seconds. Of what others wrote the names are enough.
        val classes: JavaClasses = ArchConfiguration.withThreadLocalScope(
            Function<ArchConfiguration, JavaClasses> {
                it.setResolveMissingDependenciesFromClassPath(false)
                ClassFileImporter().withImportOption(ImportOption.DoNotIncludeTests()).importPackages("daphnis")
            },
        )
    }
}
