package daphnis.app.live

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.at
import daphnis.core.scenario.BoundarySpec
import daphnis.core.scenario.WallSurfaceSpec
import daphnis.core.wall.Piston

/**
 * The walls around a state, where they stand at its [time], for who looks at it. What moves is looked up once, here:
 * a [Piston] moves on with its run.
 *
 * @param spec where the surfaces of [boundary] are, in the order in which it has them
 * @param pistons displacement of the piston at a face, numbered −x, +x, −y, +y, −z, +z from 0; null where it is not
 *   known, and then it is drawn where it began
 */
internal class SeenWalls(
    boundary: BoundaryConditions,
    private val spec: BoundarySpec?,
    val time: Double,
    pistons: (Int) -> Double? = { (boundary.walls[it]?.motion as? Piston)?.position },
) {
    private val boundary = boundary.at(time)

    private val places = DoubleArray(2 * AXES) { face ->
        val axis = face shr 1
        val rest = if (face and 1 == 0) this.boundary.box.lower(axis) else this.boundary.box.upper(axis)
        val motion = boundary.walls[face]?.motion
        rest + if (motion is Piston) pistons(face) ?: 0.0 else motion?.displacement(time) ?: 0.0
    }

    val surfaces: List<WallSurfaceSpec> = spec?.surfaces.orEmpty()

    /** Along what a surface has moved, and how far. */
    fun displacement(surface: Int): Double = boundary.walls.surfaces[surface].motion?.displacement(time) ?: 0.0

    /** Distance of a point from a surface, negative beyond it. */
    fun distance(surface: Int, at: DoubleArray): Double =
        boundary.walls.surfaces[surface].distance(at[0], at[1], at[2], time)

    /** Whether the ends of [extent] are faces of the box. */
    fun isFace(axis: Int): Boolean =
        boundary.contactFaces(axis) != ContactFaces.OPEN && boundary.box.length(axis).isFinite()

    /** The room between faces of the box, or within a surface that closes the axis; null where it is open. */
    fun extent(axis: Int): ClosedFloatingPointRange<Double>? {
        if (isFace(axis)) return places[2 * axis]..places[2 * axis + 1]
        val around = surfaces.mapNotNull { it.extent(axis) }
        return if (around.isEmpty()) null else around.maxOf { it.start }..around.minOf { it.endInclusive }
    }

    /** All walls by name; [length] writes a length with its unit. Empty without walls. */
    fun inWords(length: (Double) -> String): List<String> {
        val walled = (0 until boundary.space.dimensions).filter { boundary.contactFaces(it) == ContactFaces.WALL }
        val across = walled.joinToString("") { NAMES[it] }.takeIf { it.isNotEmpty() }?.let { "walls across $it" }
        val moved = walled.flatMap { listOf(2 * it, 2 * it + 1) }.mapNotNull { face ->
            val name = "${if (face and 1 == 0) "lower" else "upper"} ${NAMES[face shr 1]}"
            boundary.walls[face]?.motion?.let { if (it is Piston) "$name is a piston" else "$name moves" }
        }
        return listOfNotNull(across) + moved + surfaces.map { it.named { value -> length(value) } }
    }

    private companion object {
        const val AXES = 3
        val NAMES = listOf("x", "y", "z")
    }
}
