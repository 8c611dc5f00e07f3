package daphnis.core.run

import daphnis.core.CommonNumber
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.boundary.Growth
import daphnis.core.force.Drift
import daphnis.core.format.Snapshot
import daphnis.core.population.MaterialSums
import daphnis.core.population.PopulationSums
import daphnis.core.population.SpinSums
import daphnis.core.scenario.OutputSpec
import daphnis.core.source.SourceSums
import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.Need
import daphnis.core.table.TableColumns
import daphnis.core.wall.Piston
import daphnis.core.wall.pistons
import java.nio.file.Path

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

/**
 * The columns of `series.csv`; `docs/columns.md` says what they mean. A further quantity is a further line here. Those
 * from [ROTATIONAL_ENERGY] on are only there where spheres have spins, [FILLING_FACTOR] and [REDUCED_PRESSURE] where
 * they grow, those of a piston where that wall is one, and [EDGE_EVENTS] where spheres have interactions. Those of
 * [exchanged] are there for each source.
 */
public object SeriesColumns : TableColumns {
    internal val rows = Columns<SeriesRow>("series.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    @JvmField
    public val STEP: Column = rows.whole("step") { it.simulation.step }

    @JvmField
    public val TIME: Column = rows.number("time", Dimension.TIME, Need.NEEDED) { it.simulation.time }

    @JvmField
    public val PARTICLES: Column = rows.whole("particles", Need.NEEDED) { it.sums.count.toLong() }

    @JvmField
    public val COLLISIONS: Column =
        rows.whole("collisions", Need.NEEDED) { it.simulation.collisions?.counters?.collisions ?: 0 }

    @JvmField
    public val KINETIC_ENERGY: Column = rows.number("kinetic_energy", Dimension.ENERGY) { it.sums.kineticEnergy }

    @JvmField
    public val GRANULAR_TEMPERATURE: Column =
        rows.number("granular_temperature", Dimension.SPEED_SQUARED) { it.sums.granularTemperature }

    @JvmField
    public val RMS_COMPONENT_SPEED: Column =
        rows.number("rms_component_speed", Dimension.SPEED) { it.sums.rmsComponentSpeed }

    @JvmField
    public val MOMENTUM: List<Column> =
        rows.each(listOf("momentum_x", "momentum_y", "momentum_z"), Dimension.MOMENTUM) { row, axis ->
            row.sums.momentum(axis)
        }

    @JvmField
    public val POTENTIAL_ENERGY: Column = rows.number("potential_energy", Dimension.ENERGY) { it.energies.potential }

    @JvmField
    public val TOTAL_ENERGY: Column = rows.number("total_energy", Dimension.ENERGY) { it.energies.total }

    @JvmField
    public val HILL_ENERGY: Column = rows.number("hill_energy", Dimension.ENERGY) { it.energies.hill }

    @JvmField
    public val ROTATIONAL_ENERGY: Column =
        rows.number("rotational_energy", Dimension.ENERGY) { it.spins?.energyOfRotation ?: Double.NaN }

    @JvmField
    public val ROTATIONAL_TEMPERATURE: Column =
        rows.number("rotational_temperature", Dimension.SPEED_SQUARED) { it.spins?.temperature ?: Double.NaN }

    @JvmField
    public val MEAN_SPIN: List<Column> =
        rows.each(listOf("mean_spin_x", "mean_spin_y", "mean_spin_z"), Dimension.ANGULAR_SPEED) { row, axis ->
            row.spins?.mean(axis) ?: Double.NaN
        }

    @JvmField
    public val ANGULAR_MOMENTUM: List<Column> = rows.each(
        listOf("angular_momentum_x", "angular_momentum_y", "angular_momentum_z"),
        Dimension.ACTION,
    ) { row, axis -> row.angularMomentum(axis) }

    @JvmField
    public val FILLING_FACTOR: Column = rows.number("filling_factor") { row ->
        CommonNumber.FILLING_FACTOR.anywhere(row.simulation)
    }

    @JvmField
    public val REDUCED_PRESSURE: Column =
        rows.number("reduced_pressure") { it.growth?.reducedPressure ?: Double.NaN }

    private val FACES = listOf("lower_x", "upper_x", "lower_y", "upper_y", "lower_z", "upper_z")

    /** Displacement of each piston from the face of the box, by face. */
    @JvmField
    public val PISTON_POSITION: List<Column> =
        rows.each(FACES.map { "piston_position_$it" }, Dimension.LENGTH) { row, face ->
            row.pistons[face]?.position ?: Double.NaN
        }

    /** Their velocities along their axes. */
    @JvmField
    public val PISTON_SPEED: List<Column> =
        rows.each(FACES.map { "piston_speed_$it" }, Dimension.SPEED) { row, face ->
            row.pistons[face]?.speed ?: Double.NaN
        }

    /**
     * Of the motion of all pistons and in their forces: with [TOTAL_ENERGY] it is conserved where impacts conserve it.
     */
    @JvmField
    public val PISTON_ENERGY: Column =
        rows.number("piston_energy", Dimension.ENERGY) { row -> row.pistons.values.sumOf { it.energy } }

    /** Position and speed of each piston at [state], by face, as the file at [path] has it; null without its row. */
    internal fun pistons(path: Path, state: Snapshot): Map<Int, List<Double>>? {
        val row = RowsOfState.read(path, state, TIME).singleOrNull() ?: return null
        return FACES.indices.mapNotNull { face ->
            val position = row[PISTON_POSITION[face]] ?: return@mapNotNull null
            face to listOf(position, row[PISTON_SPEED[face]] ?: return@mapNotNull null)
        }.toMap()
    }

    private val ofGrowth = setOf(FILLING_FACTOR, REDUCED_PRESSURE)
    private val ofRotation = MEAN_SPIN.toSet() + ANGULAR_MOMENTUM + ROTATIONAL_ENERGY + ROTATIONAL_TEMPERATURE

    /** Name of the column of the partial temperature, an energy, of [material] in runs with materials. */
    @JvmStatic
    public fun temperatureOf(material: String): String = "temperature_$material"

    /** Passages and reflections at edges of interactions, since the start. */
    @JvmField
    public val EDGE_EVENTS: Column =
        rows.whole("edge_events") { it.simulation.collisions?.counters?.edgeEvents ?: 0 }

    /**
     * What the source number [source] has brought and taken since the start: spheres that came, that left, and that
     * found no place; and what came less what left of mass, momentum along x, y, z, and kinetic energy with that of
     * rotation.
     */
    @JvmStatic
    public fun exchanged(source: Int): List<String> = listOf(
        "came",
        "left",
        "refused",
        "mass",
        "momentum_x",
        "momentum_y",
        "momentum_z",
        "energy",
    ).map { "source${source}_$it" }

    private fun Columns<SeriesRow>.addExchanged(k: Int) {
        val (came, left, refused, mass) = exchanged(k)
        whole(came) { it.exchanged.came(k) }
        whole(left) { it.exchanged.left(k) }
        whole(refused) { it.exchanged.refused(k) }
        number(mass, Dimension.MASS) { it.exchanged.mass(k) }
        each(exchanged(k).subList(4, 7), Dimension.MOMENTUM) { row, axis -> row.exchanged.momentum(k, axis) }
        number(exchanged(k).last(), Dimension.ENERGY) { it.exchanged.energy(k) }
    }

    /** The columns of a run, at the end with one for each of [materials] and those for each of so many [sources]. */
    internal fun of(
        hasSpins: Boolean,
        materials: List<String>,
        grow: Boolean = false,
        pistons: Set<Int> = emptySet(),
        haveEdges: Boolean = false,
        sources: Int = 0,
    ): Columns<SeriesRow> {
        val ofEdges = if (haveEdges) emptyList() else listOf(EDGE_EVENTS)
        val none =
            (if (hasSpins) emptySet() else ofRotation) + (if (grow) emptySet() else ofGrowth) + without(pistons) +
                ofEdges
        return rows.without(none).also { all ->
            materials.forEachIndexed { k, name ->
                all.number(temperatureOf(name), Dimension.ENERGY) { it.materials?.temperature(k) ?: Double.NaN }
            }
            for (k in 0 until sources) all.addExchanged(k)
        }
    }

    /** What is not there where the faces [pistons] alone are such. */
    private fun without(pistons: Set<Int>): List<Column> {
        val others = FACES.indices.filter { it !in pistons }.flatMap { listOf(PISTON_POSITION[it], PISTON_SPEED[it]) }
        return if (pistons.isEmpty()) others + PISTON_ENERGY else others
    }
}
