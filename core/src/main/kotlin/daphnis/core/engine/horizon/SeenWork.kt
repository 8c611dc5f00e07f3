package daphnis.core.engine.horizon

/** What epochs have turned out to be like, by which [EpochCost] expects the next one. */
internal class SeenWork {
    /** Collisions per sphere and step in the last epoch, or in a step since; unknown below 0. */
    var collisions = -1.0

    /** Spheres found off their lines per sphere and step in the last epoch. */
    var strays = 0.0

    /** How many more lines the last epoch tested than an even distribution in space would have had it test. */
    var crowding = 1.0

    /** Entries of roamers that searches of the last epoch looked at, per sphere and step, and how many steps it had. */
    var roamers = 0.0
        private set
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

    /** The same as [roamers] for epochs of [span] steps: fast spheres, and those that look for them, fly as far. */
    fun roamersWithin(span: Double): Double = roamers * (span / this.span) * (span / this.span)

    /** How many times as much work it is to join what groups have done as [EpochCost.joining] has it. */
    var entanglement = 1.0
}
