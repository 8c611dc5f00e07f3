package daphnis.core.engine.lists

import daphnis.core.collision.StepRows
import daphnis.core.queue.Schedule
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/** What lists do at a collision: the next events of the two spheres are found anew. */
internal class ListImpact(prepared: PreparedStep, rows: StepRows, private val events: NextEvents) :
    Impact(prepared, rows, Nothing) {
    override fun changed(first: Int, second: Int) {
        events.bend(first)
        events.bend(second)
    }

    override fun outrun(first: Int, second: Int): Boolean {
        // Until it holds both, or there is no more room, as the serial engine finds when it redoes the step.
        do prepared.widen(rows, first, second) while (prepared.isOutrun(rows, first) || prepared.isOutrun(rows, second))
        return true
    }

    override fun search(place: Int, except: Int): Boolean {
        events.scan(place, rows.state[place * StepRows.STRIDE + StepRows.TIME])
        return true
    }

    /** Each sphere has one event, which takes the place of the one before. */
    private object Nothing : Schedule {
        override fun add(time: Double, first: Int, second: Int, image: Int) = Unit

        override fun removeAllOf(slot: Int) = Unit
    }
}
