package daphnis.actors.region

/** Runs the regions of a step on some framework: it delivers their commands. They answer into [Answers]. */
internal interface RegionHost {
    /** Its name in a message, such as `the actor system "host"`. */
    val name: String

    /** Whether it no longer runs anything. */
    val hasEnded: Boolean

    /** Sends [command] to its region. Called by one thread at a time; what it throws ends the step. */
    fun send(command: RegionCommand)

    /** Ends the regions as soon as they have finished their present commands, without waiting for them. */
    fun stop()
}
