package daphnis.actors.region

/** Runs the regions of an engine on some framework: it delivers their shares. They answer into [Answers]. */
internal interface RegionHost {
    /** Its name in a message, such as `the actor system "host"`. */
    val name: String

    /** Whether it no longer runs anything. */
    val hasEnded: Boolean

    /** Sends [share] to [region]. Called by one thread at a time; what it throws ends the step. */
    fun send(region: Int, share: Share)

    /** Ends the regions as soon as they have finished their present shares, without waiting for them. */
    fun stop()
}
