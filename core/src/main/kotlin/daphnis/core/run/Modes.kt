package daphnis.core.run

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.scenario.OutputSpec
import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.Need
import daphnis.core.table.TableColumns
import daphnis.core.wave.ModeQuantity
import daphnis.core.wave.ModeSums

/** The declaration of [Modes]. Its table is of the whole run or there is none. */
internal object ModesOutput : PeriodicOutput("modes", OutputSpec::modesEvery, OutputSpec::modesInterval) {
    private const val ROW_BYTES = 190

    override val tables: List<TableColumns> get() = listOf(ModeColumns)

    override fun mayChange(then: OutputTimes, now: OutputTimes): Boolean = then.isNever == now.isNever

    override fun cost(times: OutputTimes, course: Course, spheres: Int): OutputCost =
        cost(OutputSpec.MODES, times.count(course))

    override fun cost(spec: OutputSpec, course: Course, spheres: Int): OutputCost =
        cost(spec.modes, times(spec).count(course))

    private fun cost(modes: Int, states: Double) =
        (states * (modes + 1)).let { OutputCost("rows of ${ModeColumns.file}", it, it * ROW_BYTES) }

    override fun make(times: OutputTimes, sums: StepSums, files: RunFiles): Output? =
        if (times.isNever) null else Modes(times, sums, files)
}

/** `modes.csv`: at each of [times] a row for mode 0 and for each of the modes. */
internal class Modes(private val times: OutputTimes, private val sums: StepSums, files: RunFiles) : Output {
    private val rows = ModeColumns.rows
    private val file = files.table(rows)

    override fun write(simulation: Simulation) {
        if (!times.isDue(simulation)) return
        val modes = sums.modes(simulation)
        for (m in 0..modes.modes) {
            rows.write(ModeRow(simulation, modes, m), file.line())
            file.endLine()
        }
    }
}

/** The source of a row of `modes.csv`. */
internal class ModeRow(val simulation: Simulation, val sums: ModeSums, val mode: Int) {
    fun part(quantity: ModeQuantity, k: Int): Double =
        if (k == 0) sums.real(quantity, mode) else sums.imaginary(quantity, mode)
}

/** The columns of `modes.csv`; [ModeSums] says how modes are defined. */
public object ModeColumns : TableColumns {
    internal val rows = Columns<ModeRow>("modes.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    @JvmField
    public val STEP: Column = rows.step { it.simulation.step }

    @JvmField
    public val TIME: Column = rows.time { it.simulation.time }

    @JvmField
    public val MODE: Column = rows.whole(
        "mode",
        "m, from 0 to `output.modes`: a row for each",
        Need.NEEDED,
    ) { it.mode.toLong() }

    @JvmField
    public val WAVENUMBER: Column = rows.number(
        "wavenumber",
        "k = 2π m/L, L the radial edge of the box",
        Dimension.WAVENUMBER,
        Need.NEEDED,
    ) { it.sums.wavenumber(it.mode) }
    private val parts = mapOf(
        ModeQuantity.DENSITY to
            parts(
                "density",
                "of the surface density over its mean; 1 for m = 0",
                Dimension.NUMBER,
                ModeQuantity.DENSITY,
            ),
        ModeQuantity.VELOCITY_X to parts("vx", "of v_x", Dimension.SPEED, ModeQuantity.VELOCITY_X),
        ModeQuantity.VELOCITY_Y to
            parts("vy", "of v_y around the imposed flow", Dimension.SPEED, ModeQuantity.VELOCITY_Y),
        ModeQuantity.TEMPERATURE to
            parts(
                "temperature",
                "of the local granular temperature ⟨c²⟩/3",
                Dimension.SPEED_SQUARED,
                ModeQuantity.TEMPERATURE,
            ),
    )

    /** The real part of the mode of [quantity]. */
    @JvmStatic
    public fun real(quantity: ModeQuantity): Column = parts.getValue(quantity)[0]

    /** The imaginary part of the mode of [quantity]. */
    @JvmStatic
    public fun imaginary(quantity: ModeQuantity): Column = parts.getValue(quantity)[1]

    private fun parts(name: String, meaning: String, dimension: String, quantity: ModeQuantity): List<Column> {
        val names = listOf("${name}_re", "${name}_im")
        return rows.each(names, meaning, dimension, names.toSet()) { row, k -> row.part(quantity, k) }
    }
}
