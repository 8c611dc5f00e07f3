package daphnis.core.collision

import daphnis.core.population.SphereQuantity
import daphnis.core.population.SphereQuantity.Change.NEVER
import daphnis.core.population.SphereQuantity.Change.NOTED

/** Places of the columns that [StepRows] keeps beside its packed rows. */
internal object RowColumns {
    private const val KINDS = 4
    private val PACKED = listOf(SphereQuantity.POSITION, SphereQuantity.VELOCITY, SphereQuantity.RADIUS)

    /** Places of the columns that are not in a row of spheres without spins whose collisions are not noted. */
    @JvmField
    val LEAST: IntArray = sides(isNoted = false, hasSpin = false)

    /** By whether collisions are noted, and whether there are spins. */
    private val CARRIED = Array(KINDS) { sides(isNoted = it and 1 != 0, hasSpin = it and 2 != 0) }
    private val CHANGING = Array(KINDS) { kind ->
        CARRIED[kind].filter { SphereQuantity.at(it).change != NEVER }.toIntArray()
    }

    /** Places of the columns that are not in a row and that no step changes. */
    @JvmField
    val FIXED: IntArray = SphereQuantity.places { it !in PACKED && it.change == NEVER }

    /** Places of the columns that are not in a row; with [tracks] the times of collisions too. */
    fun carried(tracks: Boolean, hasSpin: Boolean): IntArray = CARRIED[kind(tracks, hasSpin)]

    /** Places of those of them that collisions change. */
    fun changing(tracks: Boolean, hasSpin: Boolean): IntArray = CHANGING[kind(tracks, hasSpin)]

    private fun kind(tracks: Boolean, hasSpin: Boolean) = (if (tracks) 1 else 0) + (if (hasSpin) 2 else 0)

    private fun sides(isNoted: Boolean, hasSpin: Boolean) =
        SphereQuantity.places { it !in PACKED && (isNoted || it.change != NOTED) && (hasSpin || !it.isOptional) }

    /** What a step of [duration] takes off the column at [place]: notes are times before the end of the step. */
    fun passed(place: Int, duration: Double): Double = if (SphereQuantity.at(place).change == NOTED) duration else 0.0
}
