package daphnis.core.cluster.bricks

/** Which bricks of a territory this process has, and how messages get to those which others have. */
internal interface BrickPlaces {
    /** The first brick of [bricks] that is here. */
    fun from(bricks: Int): Int

    /** One past the last brick of [bricks] that is here. */
    fun to(bricks: Int): Int

    /**
     * Between two phases: takes what was posted to bricks elsewhere out of [boxes] and brings what has come from there.
     * What was posted to the agreement goes to all processes.
     */
    fun carry(boxes: Mailboxes)

    /** All bricks are in this process. */
    object Here : BrickPlaces {
        override fun from(bricks: Int): Int = 0

        override fun to(bricks: Int): Int = bricks

        override fun carry(boxes: Mailboxes) = Unit
    }
}
