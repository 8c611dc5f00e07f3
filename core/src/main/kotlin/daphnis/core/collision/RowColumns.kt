package daphnis.core.collision

import daphnis.core.population.SphereQuantity
import daphnis.core.population.SphereQuantity.Change.NEVER
import daphnis.core.population.SphereQuantity.Change.NOTED

/** Places of the columns that [StepRows] keeps beside its packed rows. */
internal object RowColumns {
    private val PACKED = listOf(SphereQuantity.POSITION, SphereQuantity.VELOCITY, SphereQuantity.RADIUS)

    /** Places of the columns that are not in a row. */
    @JvmField
    val SIDES = SphereQuantity.places { it !in PACKED }

    /** The same without what collisions note. */
    @JvmField
    val UNNOTED = SphereQuantity.places { it !in PACKED && it.change != NOTED }
    private val CHANGING = SphereQuantity.places { it !in PACKED && it.change != NEVER }
    private val CHANGING_UNNOTED = SphereQuantity.places {
        it !in PACKED && it.change != NEVER && it.change != NOTED
    }

    /** Places of the columns that are not in a row and that no step changes. */
    @JvmField
    val FIXED: IntArray = SphereQuantity.places { it !in PACKED && it.change == NEVER }

    /** Places of the columns that are not in a row and that collisions change; [tracks] their times too. */
    fun changing(tracks: Boolean): IntArray = if (tracks) CHANGING else CHANGING_UNNOTED

    /** What a step of [duration] takes off the column at [place]: notes are times before the end of the step. */
    fun passed(place: Int, duration: Double): Double = if (SphereQuantity.at(place).change == NOTED) duration else 0.0
}
