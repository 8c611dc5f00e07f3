package daphnis.core

import daphnis.core.engine.Workforce

/**
 * Where the steps of a [Simulation] are computed: by this process ([LocalSteps]), or by nodes which hold its spheres.
 * Until [commit] a step can be taken back.
 */
internal interface Steps {
    /** A step begins. */
    fun begin()

    /**
     * Carries everything through the step that begins at [start].
     *
     * @param settle to be called once with the length of the step; it gives the time at the end
     * @param at says which step it is and when it ends, for messages
     */
    fun carry(start: Double, settle: (duration: Double) -> Double, at: () -> String)

    /** The step stands. */
    fun commit()

    /** Restores what was at [begin]. */
    fun takeBack()

    /** Sees to it that the population of the simulation is as at the end of the last step. */
    fun bringHome()

    /**
     * Calls [take] with those who hold the spheres; once more, from the beginning, when one of them was lost meanwhile.
     *
     * @return false when it was not called, since the population is at home as it is at the end of the last step
     */
    fun sumElsewhere(take: (RemoteParts) -> Unit): Boolean

    /** No step follows. */
    fun close()
}

/** Steps that others compute than this process. */
internal interface RemoteSteps :
    Steps,
    Workforce {
    /** No step follows. */
    override fun close()
}

/** Steps that this process computes, by the phases of [StepPhases]. */
internal class LocalSteps(private val phases: StepPhases, private val timeStep: TimeStep) : Steps {
    override fun begin() = phases.begin()

    override fun carry(start: Double, settle: (duration: Double) -> Double, at: () -> String) {
        val longest = phases.duration(timeStep)
        val duration = if (timeStep is StoppingTimeStep) timeStep.stops.duration(start, longest) else longest
        phases.kick(start, duration)
        phases.drift(start, duration)
        val end = settle(duration)
        phases.applyBoundary(end)
        phases.kickAgain(end, duration)
        phases.swap(start, end)
        phases.exchange(end, duration)
        phases.checkFinite(at)
    }

    override fun commit() = phases.commit()

    override fun takeBack() = phases.takeBack()

    override fun bringHome() = Unit

    override fun sumElsewhere(take: (RemoteParts) -> Unit): Boolean = false

    override fun close() = Unit
}
