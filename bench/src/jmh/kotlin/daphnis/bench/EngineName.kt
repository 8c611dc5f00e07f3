package daphnis.bench

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.queue.ReferenceEventQueue

/** All competitors, one parameter. */
enum class EngineName(private val make: () -> CollisionEngine) {
    SERIAL({ SerialEngine() }),

    /** The serial engine on the queue that is a sorted set: what the calendar is worth. */
    SERIAL_SORTED_SET({ SerialEngine(ReferenceEventQueue()) }),
    ;

    fun create(): CollisionEngine = make()
}
