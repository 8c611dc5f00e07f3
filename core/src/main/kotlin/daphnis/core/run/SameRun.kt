@file:JvmName("SameRun")

package daphnis.core.run

import daphnis.core.collision.GuardSpec
import daphnis.core.input.InputException
import daphnis.core.input.ValueCheck
import daphnis.core.scenario.OutputTimesCheck
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.Surroundings
import daphnis.core.scenario.TimeStepSpec
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name

/**
 * Where the run in [directory] is another than the one that [scenario] starts, one line each; nothing when it is that
 * run. The end, the engine, names and what else changes no state are not compared, nor is what follows from the
 * initial state where the scenario leaves it open: a guard, the cell of a time step, the length of a free path.
 *
 * @param source what to call the scenario in messages
 * @throws InputException when one of the two scenarios is wrong
 */
public fun differences(directory: RunDirectory, scenario: Scenario, source: String): List<String> {
    val found = ScenarioJson.read(directory.scenario)
    val expected = asResolved(scenario, found, directory, source)
    val changes = ScenarioChanges.between(ScenarioJson.write(found), expected).essential
    return changes + listOfNotNull(otherFile(scenario, found, directory))
}

/** [scenario] as a run directory holds it, with what is decided only with the initial state as in [found]. */
private fun asResolved(scenario: Scenario, found: Scenario, directory: RunDirectory, source: String): Scenario {
    val around = Surroundings.of(scenario, source)
    val isGuardOpen = scenario.guard == null || scenario.guard.isOpen
    return scenario.copy(
        guard = if (isGuardOpen) found.guard else scenario.guard,
        timeStep = around.timeStep.settledAs(found.timeStep),
        firstBody = scenario.firstBody ?: found.firstBody,
        output = OutputTimesCheck(scenario, around, ValueCheck(source)).settled(),
        placement = scenario.placement.file?.let { it.copy(path = copyOf(it, directory).name) }
            ?: scenario.placement,
        sources = scenario.settledSources,
    )
}

private fun copyOf(placement: PlacementSpec.File, directory: RunDirectory): Path =
    directory.initial(Path.of(placement.path))

/** A particle file under the same name may hold other spheres; one that is gone cannot be compared. */
private fun otherFile(scenario: Scenario, found: Scenario, directory: RunDirectory): String? {
    val placement = scenario.placement.file ?: return null
    if (found.placement.file == null) return null
    val original = Path.of(placement.path)
    val copy = copyOf(placement, directory)
    val isOther = try {
        Files.exists(original) && Files.exists(copy) && Files.mismatch(original, copy) >= 0
    } catch (e: IOException) {
        false
    }
    return if (isOther) "placement.path: $original differs from $copy, the copy with which the run was made" else null
}
