package daphnis.core.run

import daphnis.core.CommonNumber
import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.force.MutualGravity
import daphnis.core.population.PopulationSums
import daphnis.core.scenario.OutputSpec
import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.Need
import daphnis.core.table.TableColumns

/** The declaration of [Transport]. Its sums cannot begin in the middle of a run, nor end there. */
internal object TransportOutput :
    PeriodicOutput("transport", OutputSpec::transportEvery, OutputSpec::transportInterval) {
    private const val ROW_BYTES = 600

    override val tables: List<TableColumns> get() = listOf(TransportColumns, ImpactColumns)
    override val readsCollisions: Boolean get() = true
    override val sumsCollisions: Boolean get() = true

    override fun mayChange(then: OutputTimes, now: OutputTimes): Boolean = then.isNever == now.isNever

    override fun cost(times: OutputTimes, course: Course, spheres: Int): OutputCost =
        times.count(course).let { OutputCost("rows of ${TransportColumns.file}", it, it * ROW_BYTES) }

    override fun make(times: OutputTimes, sums: StepSums, files: RunFiles): Output? =
        if (times.isNever) null else Transport(times, sums, files)
}

/**
 * `transport.csv`: one row at each of [times] with the data for viscosities, pressure and energy balance. Sums over
 * collisions count from the start of the run. Also writes `impacts.csv`, the distribution of impact speeds, anew with
 * each checkpoint.
 */
internal class Transport(private val times: OutputTimes, private val sums: StepSums, private val files: RunFiles) :
    Output {
    private val rows = TransportColumns.rows(sums.haveSpins, sums.areWallsDriven, sums.surfaces, sums.haveHeat)
    private val file = files.table(rows)
    private val statistics = CollisionStatistics()
    private val walls = if (sums.areWallsDriven) WallStatistics() else null
    private val heat = if (sums.haveHeat) HeatStatistics() else null
    private var gravity = -1

    override fun open(simulation: Simulation, opening: Opening) {
        gravity = simulation.forces.indexOfFirst { it is MutualGravity }
    }

    override fun write(simulation: Simulation) {
        statistics.write(simulation)
        walls?.write(simulation)
        heat?.write(simulation)
        if (!times.isDue(simulation)) return
        rows.write(TransportRow(simulation, sums.of(simulation), statistics, walls, heat, gravity), file.line())
        file.endLine()
    }

    override fun save(state: OutputState) {
        statistics.save(state)
        walls?.save(state)
        heat?.save(state)
        files.writeWhole(ImpactColumns.file, ImpactColumns.table(statistics, files.units))
    }

    override fun restore(state: OutputState) {
        statistics.restore(state)
        walls?.restore(state)
        heat?.restore(state)
    }
}

/**
 * The source of a row of `transport.csv`; [collisions], [walls] and [heat] count from the start of the run.
 *
 * @param gravity the place of mutual gravity among the forces; −1 without it
 */
internal class TransportRow(
    val simulation: Simulation,
    val sums: PopulationSums,
    val collisions: CollisionStatistics,
    val walls: WallStatistics?,
    val heat: HeatStatistics?,
    private val gravity: Int,
) {
    val gravityXY: Double get() = if (gravity < 0) 0.0 else CommonNumber.STRESS_XY.anywhere(simulation, gravity)
}

/**
 * The columns of `transport.csv`. A further quantity is a further declaration here. Those from `virial_yx` on are only
 * there where spheres have spins, those from [WALL_WORK] on where walls move or are thermal, and those from
 * [KINETIC_HEAT] on of smooth elastic gases at rest.
 */
public object TransportColumns : TableColumns {
    private val COMPONENTS = listOf("xx", "yy", "zz", "xy", "xz", "yz")

    /** [COMPONENTS] among the nine entries by row. */
    private val NINE = intArrayOf(0, 4, 8, 1, 2, 5)

    /** The other three, which are the same in smooth spheres. */
    private val TURNED = listOf("yx", "zx", "zy")
    private val TURNED_NINE = intArrayOf(3, 6, 7)
    internal val rows = Columns<TransportRow>("transport.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    @JvmField
    public val STEP: Column = rows.step { it.simulation.step }

    @JvmField
    public val TIME: Column = rows.time { it.simulation.time }

    @JvmField
    public val PARTICLES: Column = rows.particles { it.sums.count.toLong() }

    @JvmField
    public val MASS: Column = rows.number(
        "mass",
        "of the particles, without bodies",
        Dimension.MASS,
        Need.NEEDED,
    ) { it.sums.particleMass }
    private val moments = tensor(
        "c_",
        "⟨c_a c_b⟩ of the peculiar velocities",
        Dimension.SPEED_SQUARED,
        setOf("xx", "yy", "zz", "xy"),
    ) { row, k -> row.sums.moments[k] }

    @JvmField
    public val MEAN_VELOCITY: List<Column> = rows.each(
        listOf("mean_vx", "mean_vy", "mean_vz"),
        "mean velocity around the imposed flow",
        Dimension.SPEED,
    ) { row, axis -> row.sums.mean[axis] }

    @JvmField
    public val CENTRE_Z: Column = rows.number("centre_z", "mean height", Dimension.LENGTH) { it.sums.centreZ }

    @JvmField
    public val SCALE_HEIGHT: Column = rows.number(
        "scale_height",
        "√⟨(z − centre)²⟩",
        Dimension.LENGTH,
        Need.NEEDED,
    ) { it.sums.scaleHeight }

    @JvmField
    public val GUIDING_X: Column = rows.number(
        "guiding_x",
        "Σ m X / Σ m, X the guiding centre, in Hill's frame; else the mean of x",
        Dimension.LENGTH,
    ) { it.sums.guidingX }

    @JvmField
    public val COLLISIONS: Column = rows.whole(
        "collisions",
        "since the start, like all that follow but `gravity_…` and `kinetic_…`",
        Need.NEEDED,
    ) { it.collisions.count }

    @JvmField
    public val SUM_IMPACT_SPEED: Column = rows.number(
        "sum_impact_speed",
        "Σ impact speed",
        Dimension.SPEED,
    ) { it.collisions.sumSpeed }

    @JvmField
    public val DISSIPATED: Column = rows.number(
        "dissipated",
        "kinetic energy, that of spins with it, lost in collisions of two spheres, and what bridges take",
        Dimension.ENERGY,
        Need.NEEDED,
    ) {
        it.collisions.dissipated
    }
    private val virials = tensor(
        "virial_",
        "Σ Δp_a δ_b over collisions, and events at edges",
        Dimension.ACTION,
        setOf("xy"),
    ) { row, k -> row.collisions.virial[NINE[k]] }

    @JvmField
    public val GRAVITY_XY: Column = rows.number(
        "gravity_xy",
        "stress of self-gravity, at the time",
        Dimension.ENERGY,
    ) { it.gravityXY }
    private val kinetics = tensor(
        "kinetic_",
        "⟨w_a w_b⟩, w the velocity around the imposed flow",
        Dimension.SPEED_SQUARED,
    ) { row, k -> row.sums.kinetic[k] }
    private val turned = rows.each(
        TURNED.map { "virial_$it" },
        "of rough spheres only; of others they are `virial_xy`, `virial_xz` and `virial_yz`",
        Dimension.ACTION,
    ) { row, k ->
        row.collisions.virial[TURNED_NINE[k]]
    }
    private val allVirials = virials + TURNED.zip(turned)

    @JvmField
    public val WALL_WORK: Column = rows.number(
        "wall_work",
        "energy that walls gave to spheres, less what they took; this and what follows where a wall moves or " +
            "is thermal only",
        Dimension.ENERGY,
    ) { it.walls?.given ?: 0.0 }

    @JvmField
    public val WALL_IMPULSE: List<Column> = rows.each(
        listOf("lower_x", "upper_x", "lower_y", "upper_y", "lower_z", "upper_z").map { "wall_impulse_$it" },
        "momentum that the wall gave along its normal; over area and time the pressure on it",
        Dimension.MOMENTUM,
    ) { row, face -> row.walls?.impulse(face) ?: 0.0 }

    @JvmField
    public val SURFACE_IMPULSE: List<Column> = rows.each(
        List(8) { "wall_impulse_surface_$it" },
        "the same of the first eight of `boundary.surfaces`, counted from 0, those that there are",
        Dimension.MOMENTUM,
    ) { row, k -> row.walls?.surfaceImpulse(k) ?: 0.0 }

    @JvmField
    public val KINETIC_HEAT: List<Column> = rows.each(
        listOf("x", "y", "z").map { "kinetic_heat_$it" },
        "Σ ½ m w² w_a, the heat flux that spheres carry, times volume, at the time; this and what follows of " +
            "smooth elastic gases at rest only",
        Dimension.ENERGY_SPEED,
    ) { row, axis ->
        row.sums.heat[axis]
    }

    @JvmField
    public val COLLISIONAL_HEAT: List<Column> = rows.each(
        listOf("x", "y", "z").map { "collisional_heat_$it" },
        "Σ ΔE δ_a over collisions since the start: ΔE is the kinetic energy that one sphere gains, δ points " +
            "to it from the other",
        Dimension.ENERGY_LENGTH,
    ) { row, axis ->
        row.heat?.carried(axis) ?: 0.0
    }

    /** The columns of a run with so many [surfaces]. */
    internal fun rows(
        haveSpins: Boolean,
        areWallsDriven: Boolean,
        surfaces: Int,
        haveHeat: Boolean,
    ): Columns<TransportRow> {
        val ofSpins = if (haveSpins) emptyList() else turned
        val told = if (areWallsDriven) surfaces else 0
        val ofWalls = (if (areWallsDriven) emptyList() else WALL_IMPULSE + WALL_WORK) + SURFACE_IMPULSE.drop(told)
        val ofHeat = if (haveHeat) emptyList() else KINETIC_HEAT + COLLISIONAL_HEAT
        return rows.without((ofSpins + ofWalls + ofHeat).toSet())
    }

    /** ⟨c_a c_b⟩ by component, such as `xx`. */
    @JvmStatic
    public fun moment(component: String): Column = moments.getValue(component)

    /**
     * Σ Δp_a δ_b over all collisions since the start, by component. Those of `yx`, `zx` and `zy` are in the files of
     * rough spheres alone: surfaces that rub turn the spheres, and the tensor is symmetric only on average.
     */
    @JvmStatic
    public fun virial(component: String): Column = allVirials.getValue(component)

    /** ⟨w_a w_b⟩ by component. */
    @JvmStatic
    public fun kinetic(component: String): Column = kinetics.getValue(component)

    private fun tensor(
        prefix: String,
        meaning: String,
        dimension: String,
        needed: Set<String> = emptySet(),
        value: Columns.Component<TransportRow>,
    ): Map<String, Column> {
        val names = COMPONENTS.map { prefix + it }
        val columns = rows.each(names, meaning, dimension, needed.map { prefix + it }.toSet(), value)
        return COMPONENTS.zip(columns).toMap()
    }
}
