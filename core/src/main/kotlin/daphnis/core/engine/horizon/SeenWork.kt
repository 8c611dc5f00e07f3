package daphnis.core.engine.horizon

/** What epochs have turned out to be like, by which [EpochCost] expects the next one. */
internal class SeenWork {
    /** Collisions per sphere and step in the last epoch, or in a step since; unknown below 0. */
    var collisions = -1.0

    /** Spheres found off their lines per sphere and step in the last epoch. */
    var strays = 0.0

    /** How many more lines the last epoch tested than an even distribution in space would have had it test. */
    var crowding = 1.0

    /** How many times as much work it is to join what groups have done as [EpochCost.joining] has it. */
    var entanglement = 1.0

    /** Entries of roamers that searches of the last epoch looked at, per sphere and step. */
    var roamers = 0.0
        private set

    /** How many steps ahead that epoch, or its windows, looked. */
    private var span = 1.0

    /** Told of the [roamers] in an epoch, or window, of [span] steps. */
    fun sawRoamers(roamers: Double, span: Double) {
        this.roamers = roamers
        this.span = span
    }

    /** What was bad about roamers may be over: there are [calming] times as many. */
    fun calm(calming: Double) {
        roamers *= calming
    }

    /**
     * [roamers] as expected in epochs of [span] steps. The farther ahead, the farther around themselves all look for
     * roamers, along two axes at least where there are many: by the square.
     */
    fun roamersWithin(span: Double): Double = roamers * (span / this.span) * (span / this.span)
}
