package daphnis.core.scenario

/**
 * A [Scenario] with everything decided that its author left open: what a run directory holds, so that it means the same
 * again. Its file is that of a scenario.
 *
 * @property end time at which the run ends
 * @property guard with a speed in units of speed
 * @property timeStep [TimeStepSpec.Fixed], or [TimeStepSpec.CellCrossing] with its cell
 * @property firstBody id of the first of [bodies]; [Int.MAX_VALUE] without any
 */
public class ResolvedScenario internal constructor(
    private val written: Scenario,
    public val end: Double,
    public val guard: GuardSpec,
    public val timeStep: TimeStepSpec,
    public val firstBody: Int,
) : ScenarioParts by written {
    /** As a file holds it. */
    internal val document: Scenario get() = written.copy(
        guard = guard,
        timeStep = timeStep,
        until = end,
        untilOrbits = null,
        firstBody = firstBody.takeIf { it != Int.MAX_VALUE },
    )

    /** Whether the sphere with [id] is one of [bodies]. */
    public fun isBody(id: Int): Boolean = firstBody != Int.MAX_VALUE && id >= firstBody

    /** Placed from the file [path] instead of the one it is placed from. */
    internal fun placedFrom(path: String): ResolvedScenario {
        val placement = (placement as PlacementSpec.File).copy(path = path)
        return ResolvedScenario(written.copy(placement = placement), end, guard, timeStep, firstBody)
    }
}
