package daphnis.app.describe

import daphnis.core.FixedTimeStep
import daphnis.core.FreePathTimeStep
import daphnis.core.force.MeshGravity
import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.bytes
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.measure
import daphnis.core.parallel.InlineLoop
import daphnis.core.run.Course
import daphnis.core.run.PeriodicOutputs
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.search.Grid
import daphnis.core.search.Reach
import java.util.Locale
import kotlin.math.ceil

/** What a run writes, its memory and time, and how it searches for neighbours. */
internal class CostRows(private val setup: ScenarioSetup, private val say: Quantities, private val rows: Rows) {
    private val scenario = setup.scenario
    private val size = setup.population.size
    private val dt = setup.firstStep()
    private val exact = setup.timeStep is FixedTimeStep
    private val chosen = setup.timeStep as? FreePathTimeStep
    private val steps = when {
        chosen != null -> chosenSteps(chosen)
        exact -> ceil((scenario.end - scenario.startTime) / dt - SLACK)
        else -> (scenario.end - scenario.startTime) / dt
    }

    private val space = setup.boundary.space
    private val one = one(space)
    private val course = Course(steps, scenario.startTime, scenario.end)

    fun write() {
        outputs()
        val spin = if (setup.population.hasSpin) BYTES_PER_SPIN else 0.0
        val each = ScenarioSetup.BYTES_PER_SPHERE + spin + meshBytes()
        rows.add("memory", "${bytes(size * each)} of the heap of Java, ${bytes(each)} per $one")
        time()
        val count = when {
            exact -> ""
            chosen == null -> "at least "
            else -> "about "
        } + written(steps)
        rows.add("steps", "$count of ${say.time(dt)} to time ${say.timeInUnits(scenario.end)}")
        chosen?.let { choice(it) }
        search()
    }

    /** Per sphere, of all meshes. */
    private fun meshBytes() = setup.forces.filterIsInstance<MeshGravity>().sumOf {
        val spacing = it.spacingFor(setup.population)
        val points = setup.boundary.box.let { box -> box.length(0) / spacing * (box.length(1) / spacing) }
        BYTES_PER_PULL + BYTES_PER_POINT * points / maxOf(1, size)
    }

    private fun time() {
        val rate = CollisionRate.of(setup)
        val still = steps * size * secondsPerSphereAndStep()
        val each = if (setup.frequencies == null) GAS_COLLISION_SECONDS else RING_COLLISION_SECONDS
        val half = size * (scenario.end - scenario.startTime) / 2
        val (least, most) = took(still + half * rate.least * each) to took(still + half * rate.most * each)
        val bound = if (rate.isOnlyLeast) "at least " else ""
        val seconds = if (least == most) bound + least else "$least to ${most.removePrefix("about ")}"
        val counts = listOf(half * rate.least, half * rate.most).map { number(it) }.distinct().joinToString(" to ")
        val those = if (rate.isOnlyLeast) "at least $counts collisions, $counts" else "the $counts"
        val ofStart = "with $those collisions of the start"
        val why = if (setup.frequencies == null) ofStart else "$counts collisions"
        rows.add("run time", "$seconds on one core, roughly; $why")
        val inStep = rate.most * dt
        if (inStep > MANY_IN_STEP) {
            rows.add(
                "run time",
                "about ${number(inStep)} collisions of each $one in a step, which is slow: take shorter steps",
            )
        }
    }

    /** Steps to the end if the greatest speed stays, those that outputs cut short included. */
    private fun chosenSteps(step: FreePathTimeStep): Double {
        val longest = step.next(setup.population)
        var time = scenario.startTime
        var count = 0
        while (time < scenario.end && count < MOST_COUNTED) {
            time = step.stops.timeAfter(time, step.stops.duration(time, longest))
            count++
        }
        return count * ((scenario.end - scenario.startTime) / (time - scenario.startTime))
    }

    private fun choice(step: FreePathTimeStep) {
        val speed = step.measure(setup.population, InlineLoop)
        val flow = if (step.flow == null) "" else " relative to the flow"
        val limit = "moves at most ${say.length(step.path)} in a step$flow"
        val fastest = "the fastest $one, at ${say.speed(speed)} along an axis"
        rows.add("steps", "chosen, since no force acts: $fastest, $limit")
        rows.add("steps", "so many while that speed stays; fewer where the gas cools, more where it heats up")
        if (step.stops.intervals.isNotEmpty()) {
            rows.add(
                "steps",
                "steps end at the times of outputs and at the end exactly",
            )
        }
    }

    private fun outputs() {
        for (output in PeriodicOutputs.all) {
            val cost = output.cost(scenario.output, course, size) ?: continue
            val count = cost.count
            val disk = cost.bytes
            if (count == null || disk == null) rows.add("outputs", cost.what) else row(cost.what, count, disk)
        }
        row("checkpoints kept", 2.0, 2 * CHECKPOINT_BYTES * size)
    }

    private fun row(what: String, count: Double, disk: Double) {
        if (count <= 0) return
        // `1 snapshot`, `1 row of series.csv`.
        val named = if (count == 1.0) what.replaceFirst(Regex("s\\b"), "") else what
        rows.add("outputs", "${written(count)} $named, ${bytes(disk)}")
    }

    private fun written(count: Double) = if (count < MOST_WRITTEN) "%.0f".format(Locale.ROOT, count) else number(count)

    /**
     * From the benchmarks in docs/performance.md: free motion, search and collisions of a dilute to middling system, and
     * forces.
     */
    private fun secondsPerSphereAndStep() = STEP_SECONDS + scenario.forces.sumOf { it.seconds(size) }

    private fun took(seconds: Double) = when {
        seconds < 1 -> "about a second"
        seconds < 120 -> "about ${number(ceil(seconds))} s"
        seconds < 7200 -> "about ${number(ceil(seconds / 60))} min"
        !seconds.isFinite() -> "for ever"
        seconds < 172_800 -> "about ${number(ceil(seconds / 3600))} h"
        else -> "about ${number(ceil(seconds / 86_400))} days"
    }

    private fun search() {
        val axes = 0 until space.dimensions
        val boundary = setup.boundary.during(scenario.startTime, dt) ?: setup.boundary
        val reach = Reach().apply { measure(setup.population, boundary, dt) }
        rows.add("reach in a step", axes.joinToString(" x ") { say.length(reach.bound[it]) })
        val grid = Grid().apply {
            build(setup.population, boundary, scenario.startTime, dt, reach.bound, structure = scenario.search)
        }
        for (size in 0 until grid.classes) {
            val radii = if (grid.classes > 1) ", for radii up to ${say.length(grid.largestRadius(size))}" else ""
            val cells = axes.joinToString(" x ") { "${grid.cellsAlong(it, size)}" }
            val widths = axes.joinToString(" x ") { say.length(grid.cellWidth(it, size)) }
            rows.add("cells", "$cells, each $widths$radii")
        }
    }

    private companion object {
        /** What spins add: three columns in population, packed rows and their copy, as `jmap -histo` counts them. */
        const val BYTES_PER_SPIN = 72.0

        /** Of [MeshGravity], what it keeps of each sphere and at each point of the plane, in the heap after a step. */
        const val BYTES_PER_PULL = 80.0
        const val BYTES_PER_POINT = 120.0

        /** A collision in a gas, and in a dense ring, where searches look at more spheres; overstability has 2.5 µs. */
        const val GAS_COLLISION_SECONDS = 1e-6
        const val RING_COLLISION_SECONDS = 2.5e-6

        /** Collisions per sphere and step: beyond it a search finds mostly what others undo. */
        const val MANY_IN_STEP = 3.0

        const val SLACK = 1e-6
        const val MOST_WRITTEN = 1e12
        const val MOST_COUNTED = 100_000

        const val CHECKPOINT_BYTES = 76.0

        const val STEP_SECONDS = 0.25e-6
    }
}
