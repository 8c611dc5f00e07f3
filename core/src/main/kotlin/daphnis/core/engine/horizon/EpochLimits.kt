package daphnis.core.engine.horizon

/**
 * How much work an epoch may be: so many times what the serial engine's steps should be, so that no tuning and no
 * system can make steps take very much longer in an epoch. Work is counted, and weighed by the nanoseconds of
 * [EpochCost]; the clock is not asked. Where it is too much, the serial engine takes the step ([isExceeded]).
 *
 * Searches for all, and for spheres off their lines, are an investment in several steps, and are added up over the
 * epoch. What collisions look at is weighed step by step against the collisions that there were.
 */
internal class EpochLimits {
    private var aStep = Double.POSITIVE_INFINITY
    private var invested = 0

    /** Of the searches that follow a collision. */
    var ofCollision = Double.POSITIVE_INFINITY
        private set

    /** Of a step, or window, before its first collision. */
    val ofStep: Double get() = aStep / windows
    private var windows = 1

    /** Whether anybody had more work than that. Set to true by any worker, which then ends its work. */
    @Volatile
    var isExceeded = false

    /** Begins an epoch of [tuning], whose steps are expected to [cost] so much. */
    fun begin(tuning: HorizonTuning, cost: EpochCost, isPatient: Boolean) {
        val times = if (isPatient) MOST_PATIENT else MOST
        aStep = times * cost.serialStep
        ofCollision = times * cost.serialCollision
        invested = minOf(tuning.steps, MOST_INVESTED)
        windows = tuning.windows
    }

    /** Of all searches that belong to no collision, from the start of the epoch to the end of its step number [step]. */
    fun ofSearches(step: Int): Double = aStep * (invested + step)

    private companion object {
        /** Times the work of the serial engine; and where epochs are wanted in all steps. */
        const val MOST = 3.0
        const val MOST_PATIENT = 50.0

        /** For so many steps a search for all may look ahead at once. */
        const val MOST_INVESTED = 4
    }
}
