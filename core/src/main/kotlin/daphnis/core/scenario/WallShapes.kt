package daphnis.core.scenario

import daphnis.core.boundary.Box
import daphnis.core.input.ValueCheck
import daphnis.core.wall.Wall

/** Whether walls of other shapes than faces fit to the box that they are in. */
internal object WallShapes {
    private const val AXES = "xyz"

    /** Whether one of [shapes] keeps spheres from the faces of [box] across [axis]. */
    fun areEnclosing(axis: Int, box: Box, shapes: List<Wall>) =
        shapes.any { it.encloses(axis, box.lower(axis), box.upper(axis)) }

    /** Along an axis without walls the box repeats, and a surface must repeat with it. */
    fun check(shapes: List<Wall>, walled: BooleanArray, box: Box, check: ValueCheck) {
        for ((k, shape) in shapes.withIndex()) {
            val key = "$SURFACES[$k]"
            check.must(key, !box.space.isPlane || shape.isSameAlong(2)) {
                "is not the same everywhere along z; with dimensions 2 take a cylinder along z, or a plane along it"
            }
            check.must("$key.belt", !box.space.isPlane || !shape.glides(2)) {
                "moves along z, out of the plane of the discs"
            }
            for (axis in 0 until box.space.dimensions) {
                val isOpen = !walled[axis] && !areEnclosing(axis, box, shapes)
                check.must(key, !isOpen || shape.isSameAlong(axis)) {
                    val name = AXES[axis]
                    "leaves a gap: the box repeats along $name, and the surface is not the same everywhere along " +
                        "it; give boundary.axes with $name, or a box of which a cylinder or sphere closes $name"
                }
            }
        }
    }
}
