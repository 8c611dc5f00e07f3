package daphnis.analysis.report

import daphnis.core.scenario.Scenario
import kotlin.math.abs
import kotlin.math.round

/** Beds of grains: gravity toward a wall, and walls that vibrate. */
internal object DrivenWalls {
    /** Whether a uniform force presses spheres against a wall or out of an open face, so that their density varies. */
    fun isUnderGravity(study: Study): Boolean {
        val forces = study.input.scenario?.forces.orEmpty().mapNotNull { it.acceleration }
        return forces.any { force ->
            (0 until study.last.dimensions).any { force[it] != 0.0 && !study.last.boundary.hasImages(it) }
        }
    }

    /** One line for each output that always falls into the same part of the cycle of a wall. */
    fun inStep(scenario: Scenario): List<String> {
        val frequencies = scenario.boundary.frequencies
        val output = scenario.output
        val step = scenario.timeStep.dt ?: Double.NaN
        val intervals = listOf(
            "output.seriesEvery" to output.seriesEvery * step,
            "output.seriesInterval" to output.seriesInterval,
            "output.snapshotEvery" to output.snapshotEvery * step,
            "output.snapshotInterval" to output.snapshotInterval,
            "output.transportEvery" to output.transportEvery * step,
            "output.transportInterval" to output.transportInterval,
        )
        return intervals.flatMap { (key, interval) ->
            frequencies.filter { isWhole((interval ?: 0.0) * it) }.map {
                "$key is ${ReportText.short(
                    interval!! * it,
                )} cycles of a wall: all rows or states are of one phase of " +
                    "it, and averages are of that phase. An interval that is no whole number of cycles averages over all."
            }
        }
    }

    private fun isWhole(cycles: Double) = round(cycles) >= 1 && abs(cycles - round(cycles)) < WHOLE

    private const val WHOLE = 1e-3
}
