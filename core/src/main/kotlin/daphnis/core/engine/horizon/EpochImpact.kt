package daphnis.core.engine.horizon

import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/** What an epoch does at a collision: the two spheres get new lines, and only then is searched along them. */
internal class EpochImpact(
    prepared: PreparedStep,
    private val held: GroupSpheres,
    private val course: Course,
    witness: Witness?,
) : Impact(prepared, held.rows, held.queue, witness) {
    /** The rest of the epoch. */
    interface Course {
        /** The spheres at the places [first] and [second] have met; they are the same where one has met a wall. */
        fun met(first: Int, second: Int)

        /** The sphere at [place], in [slot], has another path from its local time on. */
        fun bend(slot: Int, place: Int)

        /**
         * Finds what the sphere at [place], in [slot], can touch from its local time on, except slot [except].
         *
         * @return false when the epoch has come to an end
         */
        fun lookOut(slot: Int, place: Int, except: Int): Boolean
    }

    override fun slotOf(place: Int): Int = held.slotOf(place)

    override fun changed(first: Int, second: Int) {
        course.met(first, if (second < 0) first else second)
        course.bend(held.slotOf(first), first)
        if (second >= 0) course.bend(held.slotOf(second), second)
    }

    override fun outrun(first: Int, second: Int): Boolean {
        // Groups share the bound. It only grows, so that it matters to nobody who enlarges it first.
        synchronized(prepared) { prepared.widen(rows, first, second) }
        return true
    }

    override fun search(place: Int, except: Int): Boolean = course.lookOut(held.slotOf(place), place, except)
}
