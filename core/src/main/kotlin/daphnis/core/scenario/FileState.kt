package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.format.FormatException
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormat
import daphnis.core.population.Population
import java.nio.file.Files

/**
 * The population of a scenario that is placed from a file: positions, velocities, radii, masses and ids as they stand
 * there.
 */
internal class FileState(
    private val scenario: Scenario,
    private val boundary: BoundaryConditions,
    private val spec: PlacementSpec.File,
    private val check: ValueCheck,
) {
    /**
     * Reads the file.
     *
     * @param notices gets a line for what the file does not say
     */
    fun population(notices: MutableList<String>): Population {
        check.must("particles", scenario.particles == null) { "must be left out when the placement is a file" }
        check.must("bodies", scenario.bodies.isEmpty()) {
            "must be left out when the placement is a file, which holds them"
        }
        check.must("velocities", scenario.velocities == null) {
            "must be left out when the placement is a file, which holds them"
        }
        spec.density?.let { check.positive("placement.density", it) }
        val path = inputPath(spec.path, check.source, KEY)
        check.that(KEY, spec.path, !Files.isDirectory(path)) {
            "is a directory; name one file in it, such as a snapshot of a run"
        }
        check.that(KEY, spec.path, Files.isRegularFile(path)) { "no such file" }
        val population = try {
            val frame = frame(SnapshotFormat.of(path).read(path))
            requireTime(frame)
            withMasses(frame, notices).population()
        } catch (e: FormatException) {
            check.fail(KEY, e.message.orEmpty())
        } catch (e: IllegalArgumentException) {
            check.fail(KEY, "${spec.path}: ${e.message}")
        }
        check.that(KEY, spec.path, population.size > 0) { "holds no particle" }
        return population
    }

    private fun frame(frames: List<Snapshot>): Snapshot {
        check.that(KEY, spec.path, frames.isNotEmpty()) { "holds no state" }
        val step = spec.step ?: return checked(frames.last())
        val steps = if (frames.size <= MOST_NAMED) {
            frames.joinToString { "${it.step}" }
        } else {
            "${frames.first().step} to ${frames.last().step}"
        }
        return checked(
            frames.find { it.step == step } ?: check.fail("placement.step", "is $step; ${spec.path} has $steps"),
        )
    }

    private fun checked(frame: Snapshot): Snapshot {
        check.that(KEY, spec.path, frame.hasRadius || frame.size == 0) { "has no radii; a column radius is needed" }
        return frame
    }

    /**
     * At another time the images of a sliding boundary stand elsewhere, and spheres at its faces would overlap with
     * them.
     */
    private fun requireTime(frame: Snapshot) {
        if (spec.time != null || frame.shearOffset == 0.0) return
        check.must("placement.time", boundary.shear == null) {
            "is missing; images slide, and the state in ${spec.path} is of time ${frame.time}"
        }
    }

    /** A file says all masses or none. */
    private fun withMasses(frame: Snapshot, notices: MutableList<String>): Snapshot {
        if (frame.hasMass) {
            check.must("placement.density", spec.density == null) {
                "is ${spec.density}; leave it out, for ${spec.path} has masses"
            }
            return frame
        }
        if (spec.density == null) {
            notices += "${spec.path} has no masses: a density of 1 is taken; placement.density says another"
        }
        val density = spec.density ?: 1.0
        for (k in frame.mass.indices) {
            frame.mass[k] =
                density * 4.0 / 3.0 * Math.PI * frame.radius[k] * frame.radius[k] * frame.radius[k]
        }
        return frame
    }

    private companion object {
        const val KEY = "placement.path"
        const val MOST_NAMED = 10
    }
}
