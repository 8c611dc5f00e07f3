@file:JvmName("ParticleFile")

package daphnis.core.run

import daphnis.core.input.inputPath
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.Scenario
import java.nio.file.Path

/** The scenario with a relative particle file taken from [home]. */
public fun Scenario.atHome(home: Path): Scenario {
    val placement = placement.file ?: return this
    return copy(placement = placement.copy(path = "${home.resolve(inputPath(placement.path, name, "placement.path"))}"))
}
