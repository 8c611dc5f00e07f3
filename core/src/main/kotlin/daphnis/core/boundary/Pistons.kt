package daphnis.core.boundary

import daphnis.core.collision.CollisionRecord
import daphnis.core.population.ExactSum
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.wall.WallContact
import daphnis.core.wall.pistons

/**
 * Moves the pistons of a boundary at the end of each step, by the exact sums of the impulses that they gave: the order
 * in which an engine found them changes no bit. See [daphnis.core.wall.Piston].
 *
 * @param largest the largest radius, for which walls must leave room
 */
internal class Pistons private constructor(
    private val boundary: BoundaryConditions,
    private val record: CollisionRecord,
    private val largest: Double,
    private val partition: Partition,
) {
    private val faces = boundary.walls.pistons
    private val sums = faces.mapValues { ExactSum() }

    /**
     * A step of [duration] that ended at the time [end] is done.
     *
     * @throws IllegalStateException when there is no room left between a piston and the wall across from it
     */
    fun move(duration: Double, end: Double) {
        for (sum in sums.values) sum.clear()
        for (k in 0 until record.size) {
            if (record.isWall(k)) sums[WallContact.number(record.lower[k])]?.add(record.impulse(k))
        }
        partition.merge(sums.values.toTypedArray())
        for ((face, piston) in faces) {
            val inward = if (face and 1 == 0) 1.0 else -1.0
            piston.move(duration, inward * sums.getValue(face).value())
        }
        requireRoom(end)
    }

    private fun requireRoom(end: Double) {
        for (walls in boundary.walls.facing(end, end)) {
            check(!walls.areFaces || walls.first !in faces && walls.second !in faces || walls.apart > 2 * largest) {
                "the walls across ${AXIS_NAMES[walls.first shr 1]} are ${walls.apart} apart at time $end, and the " +
                    "largest sphere is ${2 * largest} wide; a piston needs a smaller force, or a step in which its speed changes by less"
            }
        }
    }

    companion object {
        /**
         * Those of [boundary] around [population]; null where it has none.
         *
         * @param record of the collisions of each step
         * @param partition says where the other spheres are
         * @throws IllegalArgumentException when there is no record
         */
        fun of(
            boundary: BoundaryConditions,
            record: CollisionRecord?,
            population: Population,
            partition: Partition = Partition.Whole,
        ): Pistons? {
            if (boundary.walls.pistons.isEmpty()) return null
            requireNotNull(record) {
                "a piston takes up the impulses of collisions; make CollisionForcing with recordCollisions = true"
            }
            val largest = doubleArrayOf(population.radius.maxOrNull() ?: 0.0)
            partition.max(largest)
            return Pistons(boundary, record, largest[0], partition)
        }
    }
}
