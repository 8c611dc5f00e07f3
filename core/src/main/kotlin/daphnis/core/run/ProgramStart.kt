package daphnis.core.run

import daphnis.core.Interval
import daphnis.core.hill.HillFrame
import daphnis.core.input.InputException
import daphnis.core.population.Population
import daphnis.core.population.PopulationSums
import daphnis.core.scenario.IntervalUnit
import daphnis.core.scenario.OutputSpec
import daphnis.core.wave.ModeSums
import java.nio.file.Files
import kotlin.math.abs

/** Makes the program's simulation first and then the directory, so a refusal leaves everything as it was. */
internal fun startRun(program: Program, directory: RunDirectory, force: Boolean): Run {
    val plan = planOf(program, program.population(), null)
    return begun(directory, force, plan, emptyList()) { it.begin(recordOf(program)) }
}

/** Continues from the last good checkpoint; see [Run.resume]. */
internal fun resumeRun(program: Program, directory: RunDirectory, acceptLoss: Boolean): Run =
    locked(directory, { requireSame(it, program) }) { lock ->
        val notices = ArrayList<String>()
        val checkpoints = Checkpoints(directory)
        val good = checkpoints.lastGood(acceptLoss, notices)
        val checkpoint = good?.checkpoint
        checkpoint?.scenario?.let { text ->
            requireSame(ProgramRecord.parse(text, "${directory.checkpoint}"), program, directory)
        }
        val plan = planOf(program, checkpoint?.population ?: program.population(), checkpoint?.meta)
        try {
            checkpoint?.let { from ->
                checkLater(program.until, from.meta.time, plan.endSlack, TimeWords.PLAIN) {
                    InputException("${directory.path}", "until", it)
                }
            }
        } catch (e: InputException) {
            plan.use { throw e }
        }
        goingOn(directory, plan, recordOf(program).text(), checkpoints, good, lock, notices)
    }

private fun recordOf(program: Program) = ProgramRecord(program.name, program.version)

private fun requireSame(directory: RunDirectory, program: Program) {
    directory.requireRun()
    if (Files.exists(directory.scenario)) {
        throw InputException("${directory.path}", null, "holds a run of a scenario, not of ${recordOf(program)}")
    }
    requireSame(ProgramRecord.read(directory.program), program, directory)
}

private fun requireSame(made: ProgramRecord, program: Program, directory: RunDirectory) {
    val now = recordOf(program)
    if (made.isSame(now)) return
    throw InputException("${directory.path}", null, "holds a run of $made; this is $now, which would make another run")
}

private fun requireOutput(output: OutputSpec, hasOrbits: Boolean) {
    for ((key, steps) in output.steps()) require(steps >= 0) { "output.$key is $steps; it must be at least 0" }
    for ((key, problem) in output.problems()) throw IllegalArgumentException("output.$key $problem")
    require(output.intervalUnit != IntervalUnit.ORBIT || hasOrbits) {
        "output.intervalUnit is orbit; it needs a HillFrame"
    }
}

/** As of a scenario: intervals must be longer than the round-off of the times up to [farthest]. */
private fun requireFew(output: OutputSpec, farthest: Double) {
    for ((key, interval) in output.intervals()) {
        val count = farthest / interval
        require(count <= Interval.MOST) {
            "output.$key is $interval in time; the run goes to time $farthest, $count intervals, and there can be " +
                "${Interval.MOST}"
        }
    }
}

/** The plan of [program] for [population], which is at the time of [meta], or at the start. */
private fun planOf(program: Program, population: Population, meta: CheckpointMeta?): RunPlan {
    val simulation = program.simulation(population)
    try {
        val orbits = simulation.forces.filterIsInstance<HillFrame>().firstOrNull()?.frequencies
        val output = program.output.settled(orbits?.let { 2 * Math.PI / it.omega })
        require(simulation.population === population) { "the program's simulation has another population than its own" }
        require(simulation.step == 0L) { "the program's simulation has made ${simulation.step} steps; it must be new" }
        require(!simulation.hasOutputs) { "the program's simulation has outputs; give them to the run, by name" }
        requireOutput(program.output, orbits != null)
        val readers = PeriodicOutputs.readingCollisions(output)
        require(simulation.collisions?.record != null || readers.isEmpty()) {
            "outputs need a CollisionForcing with recordCollisions = true: ${readers.joinToString()}"
        }
        require(program.until.isFinite() && program.until > simulation.runStart) {
            "the program runs until ${program.until}; it must be later than its start, ${simulation.runStart}"
        }
        if (meta != null) {
            simulation.goOnFrom(meta.time, meta.step)
            meta.put(simulation.boundary, simulation.forces)
            simulation.collisions?.let { meta.countInto(it.counters) }
        }
        if (!ModesOutput.times(output).isNever) {
            ModeSums.problem(simulation.boundary)?.let { throw IllegalArgumentException("output.modesEvery $it") }
        }
        requireFew(output, maxOf(abs(simulation.runStart), abs(program.until)))
        val boundary = simulation.boundary
        val sums = PopulationSums(boundary.meanFlow, orbits, program.firstBody, boundary.space)
        val own = program.outputs().also { RunOutputs.requireFree(it.keys) }
        return RunPlan(null, program.name, program.until, endSlack(simulation.timeStep), output, own, simulation, sums)
    } catch (e: Throwable) {
        simulation.use { throw e }
    }
}
