package daphnis.core.boundary

import daphnis.core.surface.Roughness

/**
 * Reflecting walls: the surface of a sphere never passes a face; its normal velocity is reversed at the moment of
 * contact and multiplied by [wallRestitution]. Axes for which [walled] is false are periodic. A flat box is open along
 * z.
 *
 * @param roughness of the faces −x, +x, −y, +y, −z, +z, null for a smooth one; none is rough when not given
 */
public class Walls @JvmOverloads constructor(
    override val box: Box,
    override val wallRestitution: Double = 1.0,
    private val walled: BooleanArray = booleanArrayOf(true, true, true),
    private val roughness: List<Roughness?> = emptyList(),
) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(wallRestitution in 0.0..1.0) { "wall restitution is $wallRestitution; it must be in [0, 1]" }
        require(walled.size == AXES) { "walled has ${walled.size} entries, one for each of x, y, z is needed" }
        require(roughness.isEmpty() || roughness.size == FACES) {
            "roughness has ${roughness.size} entries, one for each of the $FACES faces is needed"
        }
    }

    override fun wallRoughness(face: Int): Roughness? = roughness.getOrNull(face)

    override fun contactFaces(axis: Int): ContactFaces = when {
        axis >= space.dimensions -> ContactFaces.OPEN
        walled[axis] -> ContactFaces.WALL
        else -> ContactFaces.PERIODIC
    }

    private companion object {
        const val FACES = 6
    }
}
