package daphnis.core.boundary

import daphnis.core.surface.Roughness

/**
 * Reflecting walls: the surface of a sphere never passes a face; its normal velocity relative to the face is reversed
 * at the moment of contact and multiplied by [wallRestitution]. Axes for which [walled] is false are periodic. A flat box is
 * open along z.
 *
 * @param box where the walls are when they do not move
 * @param roughness of the faces −x, +x, −y, +y, −z, +z, null for a smooth one; none is rough when not given
 * @param faces what the same faces have of their own, null for nothing; none has when not given
 * @param wallSeed decides about all that thermal walls draw
 */
public class Walls @JvmOverloads constructor(
    override val box: Box,
    override val wallRestitution: Double = 1.0,
    private val walled: BooleanArray = booleanArrayOf(true, true, true),
    private val roughness: List<Roughness?> = emptyList(),
    private val faces: List<WallFace?> = emptyList(),
    override val wallSeed: Long = 0,
) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(wallRestitution in 0.0..1.0) { "wall restitution is $wallRestitution; it must be in [0, 1]" }
        require(walled.size == AXES) { "walled has ${walled.size} entries, one for each of x, y, z is needed" }
        requireForEach("roughness", roughness)
        requireForEach("faces", faces)
        for (face in faces.indices) {
            require(faces[face] == null || walled[face shr 1]) { "face $face is not a wall and has nothing of its own" }
            require(faces[face]?.temperature == null || wallRoughness(face) == null) {
                "the wall at face $face is thermal; it cannot be rough"
            }
            require(faces[face]?.motion !is Piston || wallRoughness(face) == null) {
                "the wall at face $face is a piston; it cannot be rough"
            }
        }
    }

    private fun requireForEach(name: String, list: List<Any?>) {
        require(list.isEmpty() || list.size == FACES) {
            "$name has ${list.size} entries, one for each of the $FACES faces is needed"
        }
    }

    override fun wallRestitution(face: Int): Double = faces.getOrNull(face)?.restitution ?: wallRestitution

    override fun wallMotion(face: Int): WallMotion? = faces.getOrNull(face)?.motion

    override fun wallTemperature(face: Int): Double? = faces.getOrNull(face)?.temperature

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
