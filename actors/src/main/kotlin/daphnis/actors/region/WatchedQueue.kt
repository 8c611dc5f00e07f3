package daphnis.actors.region

import daphnis.core.queue.BucketEventQueue
import daphnis.core.queue.EventQueue

/** The queue of a step that may be cancelled while one thread takes it: [requireWanted] is asked before each event. */
internal class WatchedQueue(private val requireWanted: Runnable, private val queue: EventQueue = BucketEventQueue()) :
    EventQueue by queue {
    override fun pop(): Boolean {
        requireWanted.run()
        return queue.pop()
    }
}
