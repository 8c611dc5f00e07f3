package daphnis.analysis.input

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.format.FormatException
import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.population.Population
import daphnis.core.run.RunDirectory

private const val MOST_BOXES = 1_000_000

/** Open space ends where the spheres of [last] do. */
internal fun bounded(boundary: BoundaryConditions, last: Population): BoundaryConditions =
    if (boundary.box.isFinite || last.size == 0) boundary else Periodic(extent(last), false, false, false)

/** The box around the spheres of [p]. */
internal fun extent(p: Population): Box {
    fun low(a: DoubleArray) = a.indices.minOf { a[it] - p.radius[it] }
    fun high(a: DoubleArray) = a.indices.maxOf { a[it] + p.radius[it] }
    return Box(low(p.x), low(p.y), low(p.z), high(p.x), high(p.y), high(p.z))
}

/** The box of a scenario is not that which a file's places were checked against. */
internal fun requireNear(boundary: BoundaryConditions, snapshot: Snapshot, where: String) {
    for (axis in 0..2) {
        if (!boundary.repeats(axis)) continue
        val farthest = MOST_BOXES * boundary.box.length(axis)
        for (k in 0 until snapshot.size) {
            val p = snapshot.position[axis][k]
            if (Math.abs(p) <= farthest) continue
            val place = "${"xyz"[axis]} of particle ${snapshot.id[k]} is $p"
            throw FormatException("$where: $place, more than $MOST_BOXES of the scenario's boxes away")
        }
    }
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
