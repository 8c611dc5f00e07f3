package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.roomAt
import daphnis.core.boundary.wrap
import daphnis.core.compression.GrownPlacement
import daphnis.core.format.Snapshot
import daphnis.core.initial.PlacementException
import daphnis.core.initial.Positions
import daphnis.core.initial.SeededRandom
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import java.math.BigDecimal
import java.math.MathContext

/**
 * Makes a state of a file one that can start, as far as the placement [spec] allows: spheres outside the box are put
 * back, and overlaps are taken away. Says what was done.
 */
internal class StateRepair(
    private val scenario: Scenario,
    private val boundary: BoundaryConditions,
    private val spec: PlacementSpec.File,
    private val check: ValueCheck,
    private val notices: MutableList<String>,
) {
    private val box = boundary.roomAt(scenario.startTime)

    /** The population of [snapshot], with what it takes. */
    fun repaired(snapshot: Snapshot): Population {
        val population = snapshot.population()
        if (population.size == 0) return population
        putBack(population, snapshot.shift)
        val repair = OverlapRepair(population, boundary, scenario.startTime, scenario.engine.threadsAtStart)
        when (spec.overlaps) {
            OverlapsName.REFUSE -> {
                requireOffWalls(population, snapshot.shift)
                requireInSurfaces(population)
            }
            OverlapsName.SHRINK -> shrink(repair)
            OverlapsName.RELAX -> relax(repair)
            OverlapsName.GROW -> grow(population, repair)
        }
        // A run counts the boxes crossed from its start on.
        return Population(PopulationColumns.joined(listOf(population)), population.materials)
    }

    private fun putBack(population: Population, shift: DoubleArray) {
        var count = 0
        var farthest = 0.0
        val isOutside = BooleanArray(population.size)
        for (axis in 0..2) {
            if (!boundary.repeats(axis)) continue
            val p = population.position(axis)
            for (k in p.indices) {
                val out = outside(p[k], axis)
                if (!(out > 0)) continue
                val isRounding = out <= ROUNDING * box.length(axis)
                if (!spec.wrap && !isRounding) refuse(population, k, axis, shift, WRAP)
                if (!isOutside[k]) count++
                isOutside[k] = true
                farthest = maxOf(farthest, out)
            }
        }
        if (count == 0) return
        boundary.putBack(population, scenario.startTime)
        val who = if (count == 1) "1 sphere is" else "$count spheres are"
        notices +=
            "${spec.path}: $who outside the box, by up to ${shown(farthest)}, and put where their images in it are"
    }

    /** By how much [p] is outside the box along [axis]. */
    private fun outside(p: Double, axis: Int) = maxOf(box.lower(axis) - p, p - box.upper(axis))

    private fun requireOffWalls(population: Population, shift: DoubleArray) {
        for (axis in 0..2) {
            if (boundary.contactFaces(axis) != ContactFaces.WALL) continue
            val p = population.position(axis)
            for (k in p.indices) {
                val r = population.radius[k]
                val into = (r + outside(p[k], axis)) / r
                if (into <= StartCheck.TOLERANCE) continue
                val wayOut = OverlapRepair.WAY_OUT.takeIf { into <= OverlapRepair.DEEPEST }
                refuse(population, k, axis, shift, wayOut)
            }
        }
    }

    private fun requireInSurfaces(population: Population) {
        val p = population
        for ((n, surface) in boundary.walls.surfaces.withIndex()) {
            for (k in 0 until p.size) {
                val r = p.radius[k]
                val into = (r - surface.distance(p.x[k], p.y[k], p.z[k], scenario.startTime)) / r
                if (into <= StartCheck.TOLERANCE) continue
                val wayOut = if (into <= OverlapRepair.DEEPEST) "; ${OverlapRepair.WAY_OUT}" else ""
                check.fail(
                    "placement",
                    "particle ${p.id[k]} with radius $r reaches out of the room, beyond " +
                        "$SURFACES[$n], by ${shown(into)} of its radius$wayOut",
                )
            }
        }
    }

    /** With the coordinates that the file has. */
    private fun refuse(population: Population, k: Int, axis: Int, shift: DoubleArray, wayOut: String?): Nothing {
        fun inFile(value: Double) = if (shift[axis] == 0.0) "$value" else shown(value + shift[axis])
        val name = "xyz"[axis]
        val lower = inFile(box.lower(axis))
        val upper = inFile(box.upper(axis))
        val place = inFile(population.position(axis)[k])
        val isOut = outside(population.position(axis)[k], axis) > 0
        val what = if (isOut) "is outside the box," else "with radius ${population.radius[k]} reaches out of the box,"
        val why = "particle ${population.id[k]} at $name = $place $what $name from $lower to $upper"
        check.fail("placement", listOfNotNull(why, wayOut).joinToString("; "))
    }

    private fun shrink(repair: OverlapRepair) {
        val deepest = allowed(repair) ?: return
        val factor = repair.shrink()
        notices += "${spec.path}: spheres overlap by up to ${shown(deepest)} of the sum of their radii; " +
            "all radii are multiplied by $factor (placement.overlaps), masses stay"
    }

    private fun relax(repair: OverlapRepair) {
        val deepest = allowed(repair) ?: return
        val moved = repair.relax()
        if (moved == null) {
            val left = repair.deepest()
            check.fail(
                "placement.overlaps",
                "is relax; in ${OverlapRepair.MOST_SWEEPS} sweeps there was no room for all spheres, and " +
                    "${left.words()} still overlap by ${shown(left.depth)}; shrink makes room",
            )
        }
        val spheres = if (moved.count == 1) "1 sphere is" else "${moved.count} spheres are"
        notices += "${spec.path}: spheres overlap by up to ${shown(deepest)} of the sum of their radii; " +
            "$spheres moved by up to ${shown(moved.farthest)} (placement.overlaps), velocities stay"
    }

    private fun grow(population: Population, repair: OverlapRepair) {
        val deepest = allowed(repair) ?: return
        check.must("placement.overlaps", (0..2).all { boundary.hasImages(it) } && boundary.shear == null) {
            "is grow; it needs a box that repeats along all axes and is not sheared"
        }
        val radii = population.radius.copyOf()
        val factor = repair.shrink()
        val start = Positions(population.x, population.y, population.z)
        val random = SeededRandom(scenario.seed * InitialState.STREAMS + InitialState.PLACES)
        val places = try {
            GrownPlacement(scenario.engine.threadsAtStart).grown(start, radii, factor, boundary.box, random)
        } catch (e: PlacementException) {
            check.fail("placement.overlaps", "is grow; ${e.message}")
        }
        places.x.copyInto(population.x)
        places.y.copyInto(population.y)
        places.z.copyInto(population.z)
        radii.copyInto(population.radius)
        notices += "${spec.path}: spheres overlap by up to ${shown(deepest)} of the sum of their radii; radii were " +
            "multiplied by $factor and grown back (placement.overlaps), so spheres have moved, and velocities stay"
    }

    /** How deep the deepest overlap is; null when there is none that matters. */
    private fun allowed(repair: OverlapRepair): Double? {
        val deepest = repair.deepest()
        if (deepest.depth <= StartCheck.TOLERANCE) return null
        check.must("placement.overlaps", deepest.depth <= OverlapRepair.DEEPEST) {
            "cannot take away that ${deepest.words()} overlap by ${shown(deepest.depth)} of the sum of their radii; " +
                "it can be at most ${OverlapRepair.DEEPEST}"
        }
        return deepest.depth
    }

    /** Without the digits that moving a box has rounded. */
    private fun shown(value: Double): String =
        if (value == 0.0) "0.0" else "${BigDecimal(value).round(MathContext(DIGITS)).toDouble()}"

    private companion object {
        /** As much as single precision loses, in parts of the box. */
        const val ROUNDING = 1e-6
        const val DIGITS = 12
        const val WRAP = "placement.wrap: true puts it where its image in the box is"
    }
}

/** Puts spheres outside the box back along axes that repeat, at [time], as the end of a step does. */
internal fun BoundaryConditions.putBack(population: Population, time: Double) {
    if ((0..2).none { contactFaces(it) == ContactFaces.WALL }) return endStep(population, time)
    // Walls, at which images never slide, are not to reflect what is in them.
    for (axis in 0..2) if (repeats(axis)) wrap(population, axis, box, 0, population.size)
}
