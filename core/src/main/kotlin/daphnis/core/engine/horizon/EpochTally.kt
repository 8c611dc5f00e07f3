package daphnis.core.engine.horizon

/** What is counted in epochs. */
internal class EpochTally {
    /** Epochs begun since the start. */
    var begun = 0L
        private set

    /**
     * Since the start: windows begun within a step, apart from the first of each; spheres that were found off their
     * lines; and spheres that were too large for cells, at the starts of epochs.
     */
    var windows = 0L
    var strays = 0L
        private set
    var giants = 0L

    /** In this epoch: collisions, spheres found off their lines, and entries of roamers looked at. */
    var collisions = 0L
    private var strayed = 0L
    var listed = 0L

    /** An epoch begins. */
    fun begin() {
        begun++
        collisions = 0
        strayed = 0
        listed = 0
    }

    fun addStrays(count: Int) {
        strays += count
        strayed += count
    }

    /** The epoch has ended after [steps] steps of [spheres], with so many entries [more]. See [EpochPlan.ended]. */
    fun end(plan: EpochPlan, steps: Int, spheres: Int, more: Long, isBroken: Boolean) {
        val sphereSteps = spheres.toDouble() * steps
        listed += more
        plan.ended(steps, collisions / sphereSteps, strayed / sphereSteps, listed / sphereSteps, isBroken)
    }
}
