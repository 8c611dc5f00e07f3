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
 * The columns of `transport.csv`; `docs/columns.md` says what they mean. A further quantity is a further line here. Those
 * from `virial_yx` on are only there where spheres have spins, those from [WALL_WORK] on where walls move or are
 * thermal, and those from [KINETIC_HEAT] on of smooth elastic gases at rest.
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
    public val STEP: Column = rows.whole("step") { it.simulation.step }

    @JvmField
    public val TIME: Column = rows.number("time", Dimension.TIME, Need.NEEDED) { it.simulation.time }

    @JvmField
    public val PARTICLES: Column = rows.whole("particles", Need.NEEDED) { it.sums.count.toLong() }

    @JvmField
    public val MASS: Column = rows.number("mass", Dimension.MASS, Need.NEEDED) { it.sums.particleMass }
    private val moments =
        tensor("c_", Dimension.SPEED_SQUARED, setOf("xx", "yy", "zz", "xy")) { row, k -> row.sums.moments[k] }

    @JvmField
    public val MEAN_VELOCITY: List<Column> =
        rows.each(listOf("mean_vx", "mean_vy", "mean_vz"), Dimension.SPEED) { row, axis -> row.sums.mean[axis] }

    @JvmField
    public val CENTRE_Z: Column = rows.number("centre_z", Dimension.LENGTH) { it.sums.centreZ }

    @JvmField
    public val SCALE_HEIGHT: Column =
        rows.number("scale_height", Dimension.LENGTH, Need.NEEDED) { it.sums.scaleHeight }

    @JvmField
    public val GUIDING_X: Column = rows.number("guiding_x", Dimension.LENGTH) { it.sums.guidingX }

    @JvmField
    public val COLLISIONS: Column = rows.whole("collisions", Need.NEEDED) { it.collisions.count }

    @JvmField
    public val SUM_IMPACT_SPEED: Column = rows.number("sum_impact_speed", Dimension.SPEED) { it.collisions.sumSpeed }

    @JvmField
    public val DISSIPATED: Column = rows.number("dissipated", Dimension.ENERGY, Need.NEEDED) {
        it.collisions.dissipated
    }
    private val virials =
        tensor("virial_", Dimension.ACTION, setOf("xy")) { row, k -> row.collisions.virial[NINE[k]] }

    @JvmField
    public val GRAVITY_XY: Column = rows.number("gravity_xy", Dimension.ENERGY) { it.gravityXY }
    private val kinetics = tensor("kinetic_", Dimension.SPEED_SQUARED) { row, k -> row.sums.kinetic[k] }
    private val turned = rows.each(TURNED.map { "virial_$it" }, Dimension.ACTION) { row, k ->
        row.collisions.virial[TURNED_NINE[k]]
    }
    private val allVirials = virials + TURNED.zip(turned)

    /** Energy that walls gave since the start, where any moves or is thermal. */
    @JvmField
    public val WALL_WORK: Column = rows.number("wall_work", Dimension.ENERGY) { it.walls?.given ?: 0.0 }

    /** Momentum that the walls −x, +x, −y, +y, −z, +z gave along their normals since the start, in the same files. */
    @JvmField
    public val WALL_IMPULSE: List<Column> = rows.each(
        listOf("lower_x", "upper_x", "lower_y", "upper_y", "lower_z", "upper_z").map { "wall_impulse_$it" },
        Dimension.MOMENTUM,
    ) { row, face -> row.walls?.impulse(face) ?: 0.0 }

    /**
     * Momentum that the first eight of the boundary's surfaces gave along their normals since the start, each in the
     * same files if it is there.
     */
    @JvmField
    public val SURFACE_IMPULSE: List<Column> = rows.each(
        List(8) { "wall_impulse_surface_$it" },
        Dimension.MOMENTUM,
    ) { row, k -> row.walls?.surfaceImpulse(k) ?: 0.0 }

    /** Σ ½ m w² w_a along x, y, z, at the time: what of the heat flux particles carry, times the volume. */
    @JvmField
    public val KINETIC_HEAT: List<Column> =
        rows.each(listOf("x", "y", "z").map { "kinetic_heat_$it" }, Dimension.ENERGY_SPEED) { row, axis ->
            row.sums.heat[axis]
        }

    /** Σ ΔE δ_a over collisions since the start: ΔE is the energy that the sphere gained to which δ points. */
    @JvmField
    public val COLLISIONAL_HEAT: List<Column> =
        rows.each(listOf("x", "y", "z").map { "collisional_heat_$it" }, Dimension.ENERGY_LENGTH) { row, axis ->
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
        dimension: String,
        needed: Set<String> = emptySet(),
        value: Columns.Component<TransportRow>,
    ): Map<String, Column> {
        val names = COMPONENTS.map { prefix + it }
        val columns = rows.each(names, dimension, needed.map { prefix + it }.toSet(), value)
        return COMPONENTS.zip(columns).toMap()
    }
}
