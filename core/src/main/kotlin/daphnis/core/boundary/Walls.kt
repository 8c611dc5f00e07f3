package daphnis.core.boundary

import daphnis.core.surface.Roughness
import daphnis.core.wall.FaceWall
import daphnis.core.wall.Wall
import daphnis.core.wall.WallFace
import daphnis.core.wall.WallSet

/**
 * Reflecting walls: the surface of a sphere never passes a face; its normal velocity relative to the face is reversed
 * at the moment of contact and multiplied by the coefficient of restitution. Axes for which [walled] is false are
 * periodic. A flat box is open along z.
 *
 * @param box where the walls are when they do not move
 * @param restitution of all walls that have none of their own, in [0, 1]
 * @param roughness of the faces −x, +x, −y, +y, −z, +z, null for a smooth one; none is rough when not given
 * @param faces what the same faces have of their own, null for nothing; none has when not given
 * @param seed decides about all that thermal walls draw
 * @param surfaces walls besides these. Axes along which a cylinder or a sphere that lies in the box keeps the spheres
 *   have no faces: they are neither walls nor periodic
 */
public class Walls @JvmOverloads constructor(
    override val box: Box,
    restitution: Double = 1.0,
    private val walled: BooleanArray = booleanArrayOf(true, true, true),
    roughness: List<Roughness?> = emptyList(),
    faces: List<WallFace?> = emptyList(),
    seed: Long = 0,
    surfaces: List<Wall> = emptyList(),
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
        require(walled.size == AXES) { "walled has ${walled.size} entries, one for each of x, y, z is needed" }
        requireForEach("roughness", roughness)
        requireForEach("faces", faces)
        for (surface in surfaces) requireFits(surface)
        for (face in faces.indices) {
            require(faces[face] == null || contactFaces(face shr 1) == ContactFaces.WALL) {
                "face $face is not a wall and has nothing of its own"
            }
        }
    }

    override val walls: WallSet = WallSet(
        List(WallSet.FACES) {
            val isWall = kinds[it shr 1] == ContactFaces.WALL
            if (isWall) box.face(it, faces.getOrNull(it) ?: WallFace(), roughness.getOrNull(it)) else null
        },
        surfaces,
        restitution,
        seed,
        box.space,
    )

    private fun requireFits(surface: Wall) {
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
        require(list.isEmpty() || list.size == WallSet.FACES) {
            "$name has ${list.size} entries, one for each of the ${WallSet.FACES} faces is needed"
        }
    }

    override fun keepsFinite(asked: PerSphereBoundary): Boolean = asked === this

    override val volume: Double by lazy { if (surfaces.isEmpty()) box.volume else RoomVolume(box, surfaces).value() }

    override fun contactFaces(axis: Int): ContactFaces = kinds[axis]

    public companion object {
        /** The faces of [box] across the axes that are [walled], which rest and are smooth, for a boundary of your own. */
        @JvmStatic
        @JvmOverloads
        public fun faces(box: Box, restitution: Double = 1.0, vararg walled: Int): WallSet = WallSet(
            List(WallSet.FACES) { if (it shr 1 in walled) box.face(it, WallFace(), null) else null },
            restitution = restitution,
            space = box.space,
        )

        private fun Box.face(number: Int, face: WallFace, roughness: Roughness?) =
            FaceWall(number, if (number and 1 == 0) lower(number shr 1) else upper(number shr 1), face, roughness)
    }
}
