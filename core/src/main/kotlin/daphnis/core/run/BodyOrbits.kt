package daphnis.core.run

import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.scenario.OutputSpec
import daphnis.core.table.TableColumns

/** The declaration of [BodyOrbits]. Rows may begin at a resume. */
internal object BodiesOutput : PeriodicOutput("bodies", OutputSpec::bodiesEvery, OutputSpec::bodiesInterval) {
    private const val ROW_BYTES = 330

    override val tables: List<TableColumns> get() = listOf(BodyColumns)
    override val readsCollisions: Boolean get() = true

    override fun cost(times: OutputTimes, course: Course, spheres: Int): OutputCost =
        times.count(course).let { OutputCost("rows of ${BodyColumns.file} for each body", it, it * ROW_BYTES) }

    override fun make(times: OutputTimes, sums: StepSums, files: RunFiles): Output? =
        if (times.isNever) null else BodyOrbits(times, sums, files)
}

/**
 * `bodies.csv`: at each of [times] a row for each satellite that feels the ring and each body that is there, in the
 * order of ids. What impacts gave since the
 * row before is summed in the run, since a body may have thousands of impacts in between; what else acted is the rest
 * of the change of its orbit ([BodyPush]).
 */
internal class BodyOrbits(private val times: OutputTimes, private val sums: StepSums, files: RunFiles) : Output {
    private val file = files.table(BodyColumns.rows)
    private var pushes = emptyList<BodyPush>()

    /** State of a checkpoint, to be taken over as soon as bodies are known. */
    private var saved: OutputState? = null
    private var lastStep = -1L

    override fun open(simulation: Simulation, opening: Opening) {
        val orbits = sums.frequencies
        val spheres = simulation.population.id.filter { it >= sums.firstBody }.sorted().map { TracedSphere(it, orbits) }
        pushes = (TracedMoon.all(simulation, orbits).reversed() + spheres).map { BodyPush(it) }
        saved?.let { state -> pushes.forEach { it.restore(state) } }
        saved = null
        lastStep = simulation.step
        for (push in pushes) if (push.isNew) push.begin(simulation)
    }

    override fun write(simulation: Simulation) {
        if (pushes.isEmpty()) return
        if (simulation.step != lastStep) addImpacts(simulation)
        lastStep = simulation.step
        if (!times.isDue(simulation)) return
        for (push in pushes) {
            val state = push.body.state(simulation) ?: continue
            BodyColumns.rows.write(BodyRow(simulation, push, state), file.line())
            file.endLine()
            push.begin(simulation)
        }
    }

    private fun addImpacts(simulation: Simulation) {
        val record = simulation.recordOfStep()
        val duration = simulation.lastDuration
        for (k in 0 until record.size) {
            // Bodies have the highest ids.
            if (record.higher[k] < sums.firstBody || record.isWall(k)) continue
            pushOn(record.higher[k])?.add(record, k, 1.0, duration)
            if (record.lower[k] >= sums.firstBody) pushOn(record.lower[k])?.add(record, k, -1.0, duration)
        }
    }

    private fun pushOn(id: Int): BodyPush? {
        for (push in pushes) if (push.body.id == id) return push
        return null
    }

    override fun save(state: OutputState) {
        for (push in pushes) push.save(state)
    }

    override fun restore(state: OutputState) {
        saved = state
    }
}
