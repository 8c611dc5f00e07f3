package daphnis.core.run

import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.boundary.Growth
import daphnis.core.force.Drift
import daphnis.core.population.MaterialSums
import daphnis.core.population.PopulationSums
import daphnis.core.population.SpinSums
import daphnis.core.scenario.OutputSpec
import daphnis.core.source.SourceSums
import daphnis.core.table.TableColumns
import daphnis.core.wall.Piston
import daphnis.core.wall.pistons

/** The declaration of [Series]. Without rows the file has its header: rows may begin at a resume. */
internal object SeriesOutput : PeriodicOutput("series", OutputSpec::seriesEvery, OutputSpec::seriesInterval) {
    private const val ROW_BYTES = 150

    override val tables: List<TableColumns> get() = listOf(SeriesColumns)

    override fun cost(times: OutputTimes, course: Course, spheres: Int): OutputCost =
        times.count(course).let { OutputCost("rows of ${SeriesColumns.file}", it, it * ROW_BYTES) }

    override fun make(times: OutputTimes, sums: StepSums, files: RunFiles): Output = Series(times, sums, files)
}

/** `series.csv`: a row at each of [times]. */
internal class Series(private val times: OutputTimes, private val sums: StepSums, files: RunFiles) : Output {
    private val exchanged = SourceSums(sums.sources)
    private val rows = SeriesColumns.of(
        sums.haveSpins,
        sums.materials,
        sums.haveGrowth,
        sums.pistons,
        sums.haveEdges,
        sums.sources,
    )
    private val file = files.table(rows)
    private var lastStep = -1L

    override fun write(simulation: Simulation) {
        if (simulation.step != lastStep && simulation.step > 0) simulation.sources?.let { exchanged.merge(it.sums) }
        lastStep = simulation.step
        if (!times.isDue(simulation)) return
        rows.write(SeriesRow(simulation, sums, exchanged), file.line())
        file.endLine()
    }

    override fun save(state: OutputState) {
        if (exchanged.sources == 0) return
        state.put(COUNTS, exchanged.counts)
        for (k in 0 until exchanged.size) state.put("$SUM$k", exchanged.sum(k).parts().toDoubleArray())
    }

    override fun restore(state: OutputState) {
        state.longs(COUNTS).copyInto(exchanged.counts)
        for (name in state.names) {
            if (!name.startsWith(SUM)) continue
            val sum = exchanged.sum(name.removePrefix(SUM).toInt())
            for (part in state.doubles(name)) sum.add(part)
        }
    }

    private companion object {
        const val COUNTS = "exchangedSpheres"
        const val SUM = "exchangedSum"
    }
}

/**
 * The source of a row of `series.csv`: a [simulation] after a step and the sums over its population.
 *
 * @property exchanged what came and left since the start of the run
 */
internal class SeriesRow(val simulation: Simulation, stepSums: StepSums, val exchanged: SourceSums) {
    val sums: PopulationSums = stepSums.of(simulation)
    val energies = Energies(simulation, stepSums)

    /** Null for smooth spheres. */
    val spins: SpinSums? = stepSums.spins(simulation)

    /** Null where spheres have no materials. */
    val materials: MaterialSums? = stepSums.materials(simulation)

    /** Null where spheres do not grow. */
    val growth: Growth? = simulation.boundary.growth

    /** By face. */
    val pistons: Map<Int, Piston> = simulation.boundary.walls.pistons

    /** The total angular momentum along [axis], NaN where space repeats or turns. */
    fun angularMomentum(axis: Int): Double {
        val repeats = (0..2).any { simulation.boundary.repeats(it) }
        if (repeats || simulation.forces.any { it is Drift }) return Double.NaN
        return spins?.angularMomentum(axis) ?: Double.NaN
    }
}
