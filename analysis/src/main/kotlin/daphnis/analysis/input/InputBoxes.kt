package daphnis.analysis.input

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.format.Snapshot
import daphnis.core.population.Population
import daphnis.core.run.RunDirectory
import daphnis.core.scenario.InputException

/** Open space ends where the spheres of [last] do. */
internal fun bounded(boundary: BoundaryConditions, last: Population): BoundaryConditions =
    if (boundary.box.isFinite || last.size == 0) boundary else Periodic(extent(last), false, false, false)

/** The box around the spheres of [p]. */
internal fun extent(p: Population): Box {
    fun low(a: DoubleArray) = a.indices.minOf { a[it] - p.radius[it] }
    fun high(a: DoubleArray) = a.indices.maxOf { a[it] + p.radius[it] }
    return Box(low(p.x), low(p.y), low(p.z), high(p.x), high(p.y), high(p.z))
}

/** A box of other lengths would be that of another run. */
internal fun requireBox(boundary: BoundaryConditions, snapshot: Snapshot, run: RunDirectory) {
    for (axis in 0..2) {
        if (!boundary.repeats(axis) && !snapshot.periodic[axis]) continue
        val length = boundary.box.length(axis)
        if (snapshot.periodic[axis] && boundary.repeats(axis) && length == snapshot.lengths[axis]) continue
        val there = "${snapshot.lengths[axis]}, ${if (snapshot.periodic[axis]) "" else "not "}periodic"
        val why = "is $length; in the run ${run.path} the box is $there along ${"xyz"[axis]}"
        throw InputException("scenario", "box.lengths[$axis]", why, isArgument = true)
    }
}
