package daphnis.analysis.report

import daphnis.core.scenario.BoundarySpec
import daphnis.core.scenario.WallFaceSpec
import daphnis.core.scenario.WallMotionSpec
import daphnis.core.scenario.WallSurfaceSpec

/** What walls do to the spheres, beside stopping them: whether they give energy, and whether they drag a flow along. */
internal object WallDrive {
    /** Whether a face or a surface moves, turns, has a belt or a temperature, or is a piston. */
    fun isSeen(boundary: BoundarySpec): Boolean {
        val walls = boundary as? BoundarySpec.Walls ?: return false
        val faces = walls.faces?.run { listOf(lowerX, upperX, lowerY, upperY, lowerZ, upperZ) }.orEmpty()
        return faces.any { isDriving(it) } || walls.surfaces.any { isDriving(it) }
    }

    /** Whether a surface turns or has a belt, so that what it touches flows along. */
    fun isFlowing(boundary: BoundarySpec?): Boolean =
        (boundary as? BoundarySpec.Walls)?.surfaces.orEmpty().any { isSliding(it) }

    /**
     * What to say of numbers around a mean flow of [study] that is not known there; nothing where no wall makes one.
     */
    fun remark(study: Study): String =
        if (isFlowing(study.input.scenario?.boundary)) "the flow that walls drag along counts as random motion" else ""

    private fun isDriving(face: WallFaceSpec?) = face != null && (face.temperature != null || isMoving(face.motion))

    private fun isDriving(surface: WallSurfaceSpec) =
        surface.temperature != null || isSliding(surface) || isMoving(motionOf(surface))

    private fun isSliding(surface: WallSurfaceSpec) = when (surface) {
        is WallSurfaceSpec.Plane -> surface.belt.any { it != 0.0 }
        is WallSurfaceSpec.Cylinder -> surface.angularVelocity != 0.0
        is WallSurfaceSpec.Sphere -> surface.angularVelocity.any { it != 0.0 }
    }

    private fun motionOf(surface: WallSurfaceSpec) = when (surface) {
        is WallSurfaceSpec.Plane -> surface.motion
        is WallSurfaceSpec.Cylinder -> null
        is WallSurfaceSpec.Sphere -> surface.motion
    }

    private fun isMoving(motion: WallMotionSpec?) = when (motion) {
        null -> false
        is WallMotionSpec.Piston -> true
        is WallMotionSpec.Steady -> motion.velocity != 0.0
        is WallMotionSpec.Sine -> motion.amplitude != 0.0
        is WallMotionSpec.Sawtooth -> motion.amplitude != 0.0
        is WallMotionSpec.BiParabolic -> motion.amplitude != 0.0
    }
}
