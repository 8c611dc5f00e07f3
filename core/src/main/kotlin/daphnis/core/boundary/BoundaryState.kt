package daphnis.core.boundary

import daphnis.core.wall.pistons

/**
 * What a boundary carries from step to step besides the spheres: the reduced pressure of growth, NaN without it, and
 * position and speed of each piston.
 */
internal var BoundaryConditions.state: DoubleArray
    get() = walls.pistons.values.flatMapTo(arrayListOf(growth?.reducedPressure ?: Double.NaN)) {
        listOf(it.position, it.speed)
    }.toDoubleArray()
    set(value) {
        growth?.resume(value[0])
        var k = 1
        for (piston in walls.pistons.values) piston.put(value[k++], value[k++])
    }
