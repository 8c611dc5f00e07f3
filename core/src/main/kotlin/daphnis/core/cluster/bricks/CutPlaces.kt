package daphnis.core.cluster.bricks

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.cluster.bricks.Cuts.Companion.AXES
import daphnis.core.population.SphereColumns
import kotlin.math.abs

/**
 * Chooses where space is cut: along each axis so that the parts hold equally many spheres, counted in a sample of them,
 * and away from bodies. Follows from the spheres alone, and changes no bit.
 */
internal class CutPlaces(private val spheres: SphereColumns, private val boundary: BoundaryConditions) {
    /** Number of spheres. */
    val count: Int get() = spheres.size

    /**
     * @param clearance by axis: how far from the surface of one of [bodies] a plane should be
     */
    fun choose(division: BrickDivision, bodies: Bodies, clearance: DoubleArray): Cuts {
        val planes = List(AXES) { axis ->
            val parts = division.along(axis)
            if (parts == 1 || !canCut(axis)) {
                DoubleArray(0)
            } else {
                awayFromBodies(axis, planes(axis, parts), bodies, clearance[axis])
            }
        }
        return Cuts(planes, boundary)
    }

    /** Whether space can be cut along [axis]. */
    fun canCut(axis: Int): Boolean = spheres.size > 1 && boundary.shear?.slideAxis != axis

    /** Positions between equally many spheres, each different; at the lower face too where [axis] is periodic. */
    private fun planes(axis: Int, parts: Int): DoubleArray {
        val position = spheres.position(axis)
        val step = maxOf(1, spheres.size / SAMPLE)
        val sample = DoubleArray((spheres.size + step - 1) / step) { position[it * step] }
        sample.sort()
        val inner = List(parts - 1) { sample[((it + 1).toLong() * sample.size / parts).toInt()] }
        if (!boundary.hasImages(axis)) return inner.distinct().toDoubleArray()
        val box = boundary.box
        val inside = inner.filter { it > box.lower(axis) && it < box.upper(axis) }
        return (listOf(box.lower(axis)) + inside).distinct().toDoubleArray()
    }

    /** Moves planes that are within [clearance] of a body, where there is room for that. */
    private fun awayFromBodies(axis: Int, planes: DoubleArray, bodies: Bodies, clearance: Double): DoubleArray {
        for (body in 0 until bodies.size) {
            val room = bodies.radius(body) + clearance
            val x = bodies.position(body, axis)
            for (k in planes.indices) {
                if (distance(axis, planes[k], x) >= room) continue
                val aside = if (signed(axis, planes[k], x) < 0) x - room else x + room
                planes[k] = inBox(axis, aside)
            }
        }
        planes.sort()
        return planes.distinct().toDoubleArray()
    }

    private fun inBox(axis: Int, x: Double): Double {
        if (!boundary.hasImages(axis)) return x
        val length = boundary.box.length(axis)
        val lower = boundary.box.lower(axis)
        val inside = x - length * Math.floor((x - lower) / length)
        return if (inside < boundary.box.upper(axis)) inside else lower
    }

    /** From [x] to [plane], or to its nearest image. */
    private fun signed(axis: Int, plane: Double, x: Double): Double {
        val d = plane - x
        if (!boundary.hasImages(axis)) return d
        val length = boundary.box.length(axis)
        return d - length * Math.rint(d / length)
    }

    private fun distance(axis: Int, plane: Double, x: Double): Double = abs(signed(axis, plane, x))

    private companion object {
        const val SAMPLE = 8192
    }
}
