package daphnis.app

import com.tngtech.archunit.core.domain.JavaClasses
import com.tngtech.archunit.core.importer.ClassFileImporter
import com.tngtech.archunit.core.importer.ImportOption
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Modules know what the design allows, and no packages know one another in a circle. */
class ArchitectureTest {
    private val classes: JavaClasses = ClassFileImporter().withImportOption(
        ImportOption.DoNotIncludeTests(),
    ).importPackages("daphnis")

    @Test
    fun `there is something to look at`() {
        assertTrue(
            classes.any { it.name == "daphnis.core.Simulation" } && classes.any { it.packageName == "daphnis.app" },
        )
    }

    @Test
    fun `core knows no other module, no coroutines, no Pekko, no plots`() {
        noClasses().that().resideInAPackage("daphnis.core..").should().dependOnClassesThat().resideInAnyPackage(
            "daphnis.actors..",
            "daphnis.analysis..",
            "daphnis.app..",
            "daphnis.bench..",
            "kotlinx.coroutines..",
            "org.apache.pekko..",
            "org.jetbrains.letsPlot..",
            "com.github.ajalt..",
        ).check(classes)
    }

    @Test
    fun `actors and analysis know core and not one another or the command line`() {
        noClasses().that().resideInAPackage("daphnis.actors..").should().dependOnClassesThat()
            .resideInAnyPackage("daphnis.analysis..", "daphnis.app..").allowEmptyShould(true).check(classes)
        noClasses().that().resideInAPackage("daphnis.analysis..").should().dependOnClassesThat()
            .resideInAnyPackage("daphnis.actors..", "daphnis.app..").check(classes)
    }

    @Test
    fun `coroutine code and Pekko code know nothing of each other`() {
        noClasses().that().resideInAPackage("daphnis.actors.coroutine..").should().dependOnClassesThat()
            .resideInAnyPackage("org.apache.pekko..", "daphnis.actors.pekko..").allowEmptyShould(true).check(classes)
        noClasses().that().resideInAPackage("daphnis.actors.pekko..").should().dependOnClassesThat()
            .resideInAnyPackage(
                "kotlinx.coroutines..",
                "daphnis.actors.coroutine..",
            ).allowEmptyShould(true).check(classes)
    }

    @Test
    fun `packages know one another without circles`() {
        slices().matching("daphnis.(**)").should().beFreeOfCycles().check(classes)
    }
}
