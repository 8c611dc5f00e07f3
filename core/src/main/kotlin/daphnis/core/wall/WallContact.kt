package daphnis.core.wall

import daphnis.core.api.EngineApi
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.NEVER
import daphnis.core.collision.StepRows

/**
 * The walls of a step. A wall is a partner with a negative number, −1 − its number in the [WallSet], and in the order
 * of events it counts as an id of that negative number.
 */
@EngineApi
public class WallContact {
    private var walls = WallSet.NONE
    private var law: CollisionLaw? = null
    private var contacts = emptyArray<ContactWall>()

    /** The place in [contacts] by number; −1 where there is none. */
    private var places = IntArray(WallSet.FACES) { -1 }

    /** Whether any wall moves or is thermal. Then collisions with walls are recorded, see [WallSet.areDriven]. */
    public val areDriven: Boolean get() = walls.areDriven

    /**
     * Takes over [walls] for spheres whose collisions have a [law], for a step of [duration] that begins at [start];
     * neither matters where walls rest and nothing falls.
     */
    @JvmOverloads
    public fun prepare(walls: WallSet, law: CollisionLaw, start: Double = 0.0, duration: Double = 0.0) {
        if (walls !== this.walls || law !== this.law) {
            this.walls = walls
            this.law = law
            contacts = walls.contacts(law)
            places = IntArray(WallSet.FACES + walls.surfaces.size) { walls.numbers.indexOf(it) }
        }
        for (wall in contacts) wall.begin(start, duration)
    }

    /**
     * The time at which sphere [slot] reaches the wall of [number], from the start of the step, or [NEVER]. A sphere
     * that overlaps the wall and moves outward touches at once.
     */
    public fun time(rows: StepRows, slot: Int, number: Int): Double {
        val place = places[number]
        return if (place < 0) NEVER else contacts[place].time(rows, slot)
    }

    /**
     * Calls [found] with the partner number of each wall that the sphere in [slot] reaches, and with the time, unless
     * that is after [until].
     */
    internal inline fun each(rows: StepRows, slot: Int, until: Double, found: (Double, Int) -> Unit) {
        for (k in contacts.indices) {
            val t = contacts[k].time(rows, slot)
            if (t <= until) found(t, partner(walls.numbers[k]))
        }
    }

    /** All of them, for steps that cover the time [span] from the start of this one. */
    internal fun within(span: Double): Array<ContactWall> = contacts.also { for (wall in it) wall.spread(span) }

    /**
     * Reflects sphere [slot] at the wall of [number] at [time]. Where walls [are driven][areDriven] it describes that in
     * [outcome]; elsewhere the caller does not read it.
     */
    public fun reflect(rows: StepRows, slot: Int, number: Int, time: Double, outcome: CollisionOutcome) {
        outcome.edge = CollisionOutcome.CONTACT
        outcome.gone = CollisionOutcome.NOBODY
        rows.advance(slot, time)
        contacts[places[number]].reflect(rows, slot, time, outcome)
    }

    public companion object {
        /** See [WallSet.FACES]. */
        public const val FACES: Int = WallSet.FACES

        /** The partner number of the wall of [number]. */
        @JvmStatic
        public fun partner(number: Int): Int = -1 - number

        /** The number of the wall with that [partner] number. */
        @JvmStatic
        public fun number(partner: Int): Int = -1 - partner
    }
}
