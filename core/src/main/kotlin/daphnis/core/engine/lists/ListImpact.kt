package daphnis.core.engine.lists

import daphnis.core.collision.StepRows
import daphnis.core.queue.Schedule
import daphnis.core.step.Impact

/**
 * What lists do at a collision: the next events of the two spheres are found anew.
 *
 * @param paths is told of all impacts; null where nobody wants to know
 */
internal class ListImpact(private val field: ListField, private val events: NextEvents, private val paths: ListPaths) :
    Impact(field.prepared, field.rows, Nothing) {
    override fun changed(first: Int, second: Int) {
        events.bend(first)
        if (second >= 0) events.bend(second)
        if (field.isShared) paths.met(first, if (second < 0) first else second, counted)
    }

    override fun outrun(first: Int, second: Int): Boolean {
        // Until it holds both, or there is no more room, as the serial engine finds when it redoes the step. Regions
        // share the bound. It only grows, so that it matters to nobody who enlarges it first.
        synchronized(prepared) {
            do {
                prepared.widen(rows, first, second)
            } while (prepared.isOutrun(rows, first) ||
                prepared.isOutrun(rows, second)
            )
        }
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
