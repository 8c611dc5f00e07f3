package daphnis.core.scenario

import daphnis.core.Clock
import daphnis.core.collision.GuardSpec

/**
 * A [Scenario] in which everything that its author left open is decided. A run directory holds it, so that it always
 * means the same. Its file is a scenario file.
 *
 * @property end time at which the run ends
 * @property guard with a speed in units of speed
 * @property timeStep [TimeStepSpec.Fixed], [TimeStepSpec.CellCrossing] with its cell, or [TimeStepSpec.Automatic] with
 *   its path
 *
 * @property output with intervals in units of time
 * @property firstBody id of the first of [bodies]; [Int.MAX_VALUE] without any
 */
public class ResolvedScenario internal constructor(
    private val written: Scenario,
    public val end: Double,
    public val guard: GuardSpec,
    public val timeStep: TimeStepSpec,
    public val firstBody: Int,
    override val output: OutputSpec,
) : ScenarioParts by written {
    /** The scenario as it is in a file. */
    internal val document: Scenario get() = written.copy(
        guard = guard,
        timeStep = timeStep,
        until = end,
        untilOrbits = null,
        firstBody = firstBody.takeIf { it != Int.MAX_VALUE },
        output = output,
    )

    /** The clock by which the run's times are counted. */
    public val clock: Clock get() = clock(timeStep)

    /** Whether the sphere with [id] is one of [bodies]. */
    public fun isBody(id: Int): Boolean = firstBody != Int.MAX_VALUE && id >= firstBody

    /** The same scenario, but placed from the file [path]. */
    internal fun placedFrom(path: String): ResolvedScenario {
        val placement = placement.file!!.copy(path = path)
        return ResolvedScenario(written.copy(placement = placement), end, guard, timeStep, firstBody, output)
    }
}
