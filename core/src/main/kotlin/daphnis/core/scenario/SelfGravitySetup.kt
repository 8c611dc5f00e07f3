package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.Force
import daphnis.core.force.MeshGravity
import daphnis.core.force.RadialGravity
import daphnis.core.force.SelfGravity
import daphnis.core.input.ValueCheck

/** Makes the gravity among all spheres of a scenario, by the method that it names. */
internal class SelfGravitySetup(private val boundary: BoundaryConditions, private val check: ValueCheck) {
    /** @param constant G in the scenario's units */
    fun force(spec: ForceSpec.SelfGravity, key: String, constant: () -> Double): Force {
        refuseOutOfRange(spec, key)
        return force(spec, key, constant())
    }

    private fun refuseOutOfRange(spec: ForceSpec.SelfGravity, key: String) {
        check.that("$key.openingAngle", spec.openingAngle, spec.openingAngle >= 0 && spec.openingAngle <= 1) {
            "must be in [0, 1]"
        }
        check.that("$key.softening", spec.softening, spec.softening >= 0) { "must be at least 0" }
        check.that("$key.images", spec.images, spec.images in 0..SelfGravity.MOST_IMAGES) {
            "must be in 0..${SelfGravity.MOST_IMAGES}"
        }
        refuseKeysOfOthers(spec, key)
    }

    private fun force(spec: ForceSpec.SelfGravity, key: String, constant: Double): Force = when (spec.method) {
        GravityMethod.TREE -> SelfGravity(boundary, constant, spec.openingAngle, spec.softening, spec.images)
        GravityMethod.MESH -> mesh(spec, key, constant)
        GravityMethod.RADIAL_MODES -> radial(spec, key, constant)
    }

    private fun mesh(spec: ForceSpec.SelfGravity, key: String, constant: Double): MeshGravity {
        check.must("$key.method", MeshGravity.fits(boundary)) {
            "is mesh; it needs a box that repeats along x and y, slides along y if at all, and is open along z"
        }
        val spacing = spec.spacing ?: return MeshGravity(boundary, constant, spec.softening)
        check.positive("$key.spacing", spacing)
        val points = boundary.box.length(0) / spacing * (boundary.box.length(1) / spacing)
        check.that("$key.spacing", spacing, points <= MOST_POINTS) {
            "makes more than ${MOST_POINTS.toInt()} points in a plane; take a greater one"
        }
        return MeshGravity(boundary, constant, spec.softening, spacing)
    }

    private fun radial(spec: ForceSpec.SelfGravity, key: String, constant: Double): RadialGravity {
        check.must("$key.method", RadialGravity.fits(boundary)) {
            "is radial-modes; it needs a box that repeats along x and has a length along y"
        }
        val modes = spec.modes ?: check.fail("$key.modes", "is missing; radial-modes needs it")
        check.that("$key.modes", modes, modes in 1..RadialGravity.MOST_MODES) {
            "must be in 1..${RadialGravity.MOST_MODES}"
        }
        check.must("$key.softening", spec.softening == 0.0) { "goes with the methods tree and mesh" }
        return RadialGravity(boundary, constant, modes)
    }

    private fun refuseKeysOfOthers(spec: ForceSpec.SelfGravity, key: String) {
        val usual = ForceSpec.SelfGravity()
        val isTree = spec.method == GravityMethod.TREE
        check.must("$key.openingAngle", isTree || spec.openingAngle == usual.openingAngle) {
            "goes with the method tree"
        }
        check.must("$key.images", isTree || spec.images == usual.images) { "goes with the method tree" }
        check.must("$key.spacing", spec.spacing == null || spec.method == GravityMethod.MESH) {
            "goes with the method mesh"
        }
        check.must("$key.modes", spec.modes == null || spec.method == GravityMethod.RADIAL_MODES) {
            "goes with the method radial-modes"
        }
    }

    private companion object {
        /** In a plane of a mesh: some 0.3 GB in eight planes. */
        const val MOST_POINTS = 4e6
    }
}
