package daphnis.core.collision

import daphnis.core.population.SphereQuantity
import daphnis.core.population.SphereQuantity.Change.NEVER
import daphnis.core.population.SphereQuantity.Change.NOTED

/** Places of the columns that [StepRows] keeps beside its packed rows. */
internal object RowColumns {
    private val PACKED = listOf(SphereQuantity.POSITION, SphereQuantity.VELOCITY, SphereQuantity.RADIUS)

    /** Places of the columns that are not in a row of spheres without optional quantities whose collisions are not noted. */
    @JvmField
    val LEAST: IntArray = sides(isNoted = false, optional = 0)

    /** By whether collisions are noted, and the set of optional quantities. */
    private val CARRIED = Array(2 * SphereQuantity.SETS) { sides(isNoted = it and 1 != 0, optional = it shr 1) }
    private val CHANGING = Array(CARRIED.size) { kind ->
        CARRIED[kind].filter { SphereQuantity.at(it).change != NEVER }.toIntArray()
    }
    private val FIXED = Array(SphereQuantity.SETS) { optional ->
        CARRIED[kind(tracks = false, optional)].filter { SphereQuantity.at(it).change == NEVER }.toIntArray()
    }

    /** Places of the columns that are not in a row and that no step changes. */
    fun fixed(optional: Int): IntArray = FIXED[optional]

    /** Places of the columns that are not in a row; with [tracks] the times of collisions too. */
    fun carried(tracks: Boolean, optional: Int): IntArray = CARRIED[kind(tracks, optional)]

    /** Places of those of them that collisions change. */
    fun changing(tracks: Boolean, optional: Int): IntArray = CHANGING[kind(tracks, optional)]

    private fun kind(tracks: Boolean, optional: Int) = (if (tracks) 1 else 0) + 2 * optional

    private fun sides(isNoted: Boolean, optional: Int) =
        SphereQuantity.places { it !in PACKED && (isNoted || it.change != NOTED) && it.isIn(optional) }

    /** What a step of [duration] takes off the column at [place]: notes are times before the end of the step. */
    fun passed(place: Int, duration: Double): Double = if (SphereQuantity.at(place).change == NOTED) duration else 0.0
}
