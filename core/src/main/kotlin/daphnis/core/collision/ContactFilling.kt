package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.surface.SurfaceContact

/** Fills in what laws are told of the spheres [one] and [other], which touch; the one with the lower id is the first. */
internal fun SurfaceContact.ofPair(rows: StepRows, one: Int, other: Int) {
    val isInOrder = rows.id[one] < rows.id[other]
    val first = if (isInOrder) one else other
    val second = if (isInOrder) other else one
    firstRadius = rows.state[first * STRIDE + RADIUS]
    secondRadius = rows.state[second * STRIDE + RADIUS]
    firstMass = rows.mass[first]
    secondMass = rows.mass[second]
    firstMaterial = material(rows, first)
    secondMaterial = material(rows, second)
}

/** The same of the sphere [slot] and a wall. */
internal fun SurfaceContact.ofWall(rows: StepRows, slot: Int) {
    firstRadius = rows.state[slot * STRIDE + RADIUS]
    secondRadius = Double.POSITIVE_INFINITY
    firstMass = rows.mass[slot]
    secondMass = Double.POSITIVE_INFINITY
    firstMaterial = material(rows, slot)
    secondMaterial = WALL
}

/** Where nothing is said of materials, all spheres are of one. */
private fun material(rows: StepRows, slot: Int): Int = if (rows.hasMaterials) rows.material[slot].toInt() else 0

private const val WALL = -1
