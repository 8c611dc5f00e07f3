package daphnis.actors.region

/** Runs the regions of a step on some framework: takes their commands to them. They answer into [Answers]. */
internal interface RegionHost {
    /** What to call it in a message, such as `the actor system "host"`. */
    val name: String

    /** Whether it runs nothing any more. */
    val hasEnded: Boolean

    /** Sends [command] to its region. Called by one thread at a time; what it throws ends the step. */
    fun send(command: RegionCommand)

    /** Ends the regions as soon as they have done what they are at, without waiting for them. */
    fun stop()
}
