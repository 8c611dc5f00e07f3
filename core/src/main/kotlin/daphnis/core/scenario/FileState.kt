package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.format.FormatException
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormats
import daphnis.core.format.Species
import daphnis.core.initial.SeededRandom
import daphnis.core.input.ValueCheck
import daphnis.core.input.inputPath
import daphnis.core.population.Population
import daphnis.core.population.SphereQuantity
import java.nio.file.Files

/**
 * The population of a scenario that is placed from a file: positions, velocities, radii, masses and ids as they are
 * there.
 *
 * @param materials names of what spheres are made of, by number
 * @param start the state itself, when no file has to be read for it
 */
internal class FileState(
    private val scenario: Scenario,
    private val boundary: BoundaryConditions,
    private val spec: PlacementSpec.File,
    private val check: ValueCheck,
    private val materials: List<String>,
    private val start: Snapshot? = null,
) {
    private val space = boundary.space
    private val spins = InitialSpins(scenario, boundary, check)

    /**
     * Reads the file.
     *
     * @param notices receives a line for each quantity that the file does not have, and what else is to be said of it
     * @param random for spins that the file does not have
     */
    fun population(notices: MutableList<String>, random: () -> SeededRandom): Population {
        check.must("particles", scenario.particles == null) { "must be left out when the placement is a file" }
        check.must("bodies", scenario.bodies.isEmpty() || scenario.firstBody != null) {
            "must be left out when the placement is a file, which holds them"
        }
        check.must("velocities", scenario.velocities == null) {
            "must be left out when the placement is a file, which holds them"
        }
        spec.density?.let { check.positive("placement.density", it) }
        val population = try {
            val snapshot = start ?: chosen(read(notices))
            requireTime(snapshot)
            requireInPlane(snapshot)
            // A state of a run has been compared with the other scenario.
            if (start == null) requireBox(snapshot, notices)
            val free = if (scenario.interactions.any { it.remembers }) snapshot else snapshot.with(bound = null)
            val all = withMaterials(withSpins(withMasses(free, notices), notices), notices)
            val repaired = StateRepair(scenario, boundary, spec, check, notices).repaired(all)
            if (repaired.hasSpin) repaired else spins.drawn(repaired, bodies = 0, random())
        } catch (e: FormatException) {
            check.fail(KEY, e.message.orEmpty())
        } catch (e: IllegalArgumentException) {
            check.fail(KEY, "${spec.path}: ${e.message}")
        }
        check.that(KEY, spec.path, population.size > 0) { "holds no particle" }
        checkBodies(population)
        return population
    }

    private fun read(notices: MutableList<String>): List<Snapshot> {
        val path = inputPath(spec.path, check.source, KEY)
        check.that(KEY, spec.path, !Files.isDirectory(path)) {
            "is a directory; name one file in it, such as a snapshot of a run"
        }
        check.that(KEY, spec.path, Files.isRegularFile(path)) { "no such file" }
        return SnapshotFormats.read(path, notices)
    }

    /** In the scenario of a run that started from another one, bodies are the spheres from `firstBody` on. */
    private fun checkBodies(population: Population) {
        if (scenario.bodies.isEmpty()) return
        val first = scenario.firstBody(population.size)
        val highest = population.id.max()
        check.that("firstBody", first, highest.toLong() < first.toLong() + scenario.bodies.size) {
            "there are ${scenario.bodies.size} bodies; ${spec.path} has a sphere with id $highest"
        }
    }

    private fun chosen(snapshots: List<Snapshot>): Snapshot {
        check.that(KEY, spec.path, snapshots.isNotEmpty()) { "holds no state" }
        val step = spec.step ?: return checked(snapshots.last())
        val steps = if (snapshots.size <= MOST_NAMED) {
            snapshots.joinToString { "${it.step}" }
        } else {
            "${snapshots.first().step} to ${snapshots.last().step}"
        }
        return checked(
            snapshots.find { it.step == step } ?: check.fail("placement.step", "is $step; ${spec.path} has $steps"),
        )
    }

    private fun checked(snapshot: Snapshot): Snapshot {
        val says = snapshot.hasRadius || snapshot.size == 0
        check.that(KEY, spec.path, says) { "has no radii; a column radius is needed" }
        return snapshot
    }

    /**
     * At another time the images of a sliding boundary are elsewhere, and spheres at its faces would overlap with them.
     */
    private fun requireTime(snapshot: Snapshot) {
        if (spec.time != null || snapshot.shearOffset == 0.0) return
        check.must("placement.time", boundary.shear == null) {
            val moment = if (snapshot.hasTime) "is of time ${snapshot.time}" else "does not say of which time it is"
            "is missing; images slide, and the state in ${spec.path} $moment"
        }
    }

    /** Discs are in the plane z = 0. */
    private fun requireInPlane(snapshot: Snapshot) {
        check.that(KEY, spec.path, space.isPlane || !snapshot.isFlat) {
            "has no z, or a box thinner than they are: these are discs, which need dimensions 2"
        }
        if (!space.isPlane) return
        for (place in OUT_OF_PLANE) {
            val column = snapshot.column(place)
            val k = column.indices.find { column[it] != 0.0 } ?: continue
            check.fail(
                KEY,
                "${spec.path}: particle ${snapshot.id[k]} has ${OUT_OF_PLANE_NAMES[place]} = ${column[k]}; " +
                    "it must be 0, with dimensions 2",
            )
        }
    }

    /** Says what the file does not have. In another box spheres would be elsewhere, or touch other images. */
    private fun requireBox(snapshot: Snapshot, notices: MutableList<String>) {
        val difference = BoxDifference.of(boundary, snapshot, scenario.startTime, spec.path)
        if (difference != null) check.fail(difference.key, difference.problem)
        BoxDifference.ofFaces(boundary, snapshot, spec.path)?.let { notices += it }
        if (!snapshot.hasVelocity && snapshot.size > 0) {
            notices += "${spec.path} has no velocities: all spheres start at rest"
        }
    }

    /** What does not spin in the scenario loses the spins of the file, and is told so. */
    private fun withSpins(snapshot: Snapshot, notices: MutableList<String>): Snapshot {
        spins.check()
        if (!snapshot.hasSpin) {
            if (spins.areThere && scenario.spins == null && snapshot.size > 0) {
                notices += "${spec.path} has no angular velocities: all spheres start without spin; spins sets others"
            }
            return snapshot
        }
        if (spins.areThere) {
            check.must("spins", scenario.spins == null) { "must be left out; ${spec.path} has angular velocities" }
            return snapshot
        }
        notices += "${spec.path} has angular velocities, which are dropped: spheres are smooth without roughness"
        return snapshot.with(known = snapshot.known - SphereQuantity.SPIN)
    }

    /** What has no materials in the scenario loses those of the file, and is told so. */
    private fun withMaterials(snapshot: Snapshot, notices: MutableList<String>): Snapshot {
        if (materials.isEmpty()) {
            if (!snapshot.hasMaterials) return snapshot
            val names = snapshot.materials.joinToString()
            notices += "${spec.path} has materials, $names, which are dropped: placement.materials keeps them"
            return snapshot.withoutMaterials()
        }
        val said = if (snapshot.hasMaterials) Species.of(snapshot) else snapshot.species
        val placeholder = if (snapshot.hasMaterials) null else said?.placeholder(materials)
        if (said != null && placeholder == null) {
            val numbers = try {
                said.numbers(materials)
            } catch (e: FormatException) {
                check.fail("placement.materials", "${spec.path}: ${e.message}")
            }
            return snapshot.withMaterials(numbers, materials)
        }
        if (materials.size > 1) {
            notices +=
                "${spec.path} does not say what spheres are made of${placeholder?.let { " but '$it'" }.orEmpty()}: " +
                "all are of the first material, ${materials[0]}"
        }
        return snapshot.withMaterials(IntArray(snapshot.size), materials)
    }

    /** A file has all masses or none. */
    private fun withMasses(snapshot: Snapshot, notices: MutableList<String>): Snapshot {
        if (snapshot.hasMass) {
            check.must("placement.density", spec.density == null) {
                "is ${spec.density}; leave it out, since ${spec.path} has masses"
            }
            return snapshot
        }
        if (spec.density == null) {
            notices += "${spec.path} has no masses: a density of 1 is assumed; placement.density sets another"
        }
        val density = spec.density ?: 1.0
        for (k in snapshot.mass.indices) {
            val r = snapshot.radius[k]
            // Of spheres in the order of products that is in the bits of runs.
            snapshot.mass[k] =
                if (space.isPlane) density * space.volume(r) else density * 4.0 / 3.0 * Math.PI * r * r * r
            check.mass("placement.density", density, r, snapshot.mass[k])
        }
        return snapshot
    }

    private companion object {
        const val KEY = "placement.path"
        const val MOST_NAMED = 10

        /** Names by place of what discs have none of. */
        val OUT_OF_PLANE_NAMES = listOf(SphereQuantity.POSITION, SphereQuantity.VELOCITY, SphereQuantity.SPIN)
            .flatMap { q ->
                q.places.zip(q.columns)
            }.filter { it.second in setOf("z", "vz", "omegax", "omegay") }.toMap()
        val OUT_OF_PLANE = OUT_OF_PLANE_NAMES.keys
    }
}
