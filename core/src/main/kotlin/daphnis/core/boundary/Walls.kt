package daphnis.core.boundary

import daphnis.core.surface.Roughness

/**
 * Reflecting walls: the surface of a sphere never passes a face; its normal velocity relative to the face is reversed
 * at the moment of contact and multiplied by [wallRestitution]. Axes for which [walled] is false are periodic. A flat
 * box is open along z.
 *
 * @param box where the walls are when they do not move
 * @param roughness of the faces −x, +x, −y, +y, −z, +z, null for a smooth one; none is rough when not given
 * @param faces what the same faces have of their own, null for nothing; none has when not given
 * @param wallSeed decides about all that thermal walls draw
 * @param surfaces walls besides these. Axes along which a cylinder or a sphere that lies in the box keeps the spheres
 *   have no faces: they are neither walls nor periodic
 */
public class Walls @JvmOverloads constructor(
    override val box: Box,
    override val wallRestitution: Double = 1.0,
    private val walled: BooleanArray = booleanArrayOf(true, true, true),
    private val roughness: List<Roughness?> = emptyList(),
    private val faces: List<WallFace?> = emptyList(),
    override val wallSeed: Long = 0,
    override val surfaces: List<WallSurface> = emptyList(),
) : PerSphereBoundary {
    private val kinds = Array(AXES) { axis ->
        when {
            axis >= box.space.dimensions -> ContactFaces.OPEN
            surfaces.any { it.encloses(axis, box.lower(axis), box.upper(axis)) } -> ContactFaces.OPEN
            walled.getOrElse(axis) { false } -> ContactFaces.WALL
            else -> ContactFaces.PERIODIC
        }
    }

    init {
        requireFinite(box) { true }
        require(wallRestitution in 0.0..1.0) { "wall restitution is $wallRestitution; it must be in [0, 1]" }
        require(walled.size == AXES) { "walled has ${walled.size} entries, one for each of x, y, z is needed" }
        requireForEach("roughness", roughness)
        requireForEach("faces", faces)
        for (surface in surfaces) requireFits(surface)
        for (face in faces.indices) {
            require(faces[face] == null || contactFaces(face shr 1) == ContactFaces.WALL) {
                "face $face is not a wall and has nothing of its own"
            }
            require(faces[face]?.temperature == null || wallRoughness(face) == null) {
                "the wall at face $face is thermal; it cannot be rough"
            }
            require(faces[face]?.motion !is Piston || wallRoughness(face) == null) {
                "the wall at face $face is a piston; it cannot be rough"
            }
        }
    }

    private fun requireFits(surface: WallSurface) {
        for (axis in 0 until space.dimensions) {
            require(!hasImages(axis) || surface.isSameAlong(axis)) {
                "$surface is not the same everywhere along ${AXIS_NAMES[axis]}, where the box is periodic"
            }
        }
        require(!space.isPlane || surface.isSameAlong(2)) {
            "$surface is not the same everywhere along z, as one of a plane must be"
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

    override val volume: Double by lazy { if (surfaces.isEmpty()) box.volume else RoomVolume(box, surfaces).value() }

    override fun contactFaces(axis: Int): ContactFaces = kinds[axis]

    private companion object {
        const val FACES = 6
    }
}
