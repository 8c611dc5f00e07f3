package daphnis.core.run

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord
import daphnis.core.scenario.OutputSpec
import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.TableColumns

/** The declaration of [CollisionLog]. A log cannot begin in the middle of a run, nor end there. */
internal object CollisionLogOutput : PeriodicOutput("collisions", OutputSpec::collisionLog) {
    private const val ROW_BYTES = 150

    override val tables: List<TableColumns> get() = listOf(CollisionColumns)
    override val readsCollisions: Boolean get() = true

    override fun mayChange(then: Int, now: Int): Boolean = then == now

    override fun cost(every: Int, steps: Double, spheres: Int): OutputCost? =
        if (every > 0) OutputCost("${CollisionColumns.file}, some $ROW_BYTES B per collision") else null

    override fun make(every: Int, sums: StepSums, files: RunFiles): Output? =
        if (every > 0) CollisionLog(files) else null
}

/** `collisions.csv`: one row per collision, in time order. */
internal class CollisionLog(files: RunFiles) : Output {
    private val file = files.table(CollisionColumns.rows)

    override fun write(simulation: Simulation) {
        if (simulation.step == 0L) return
        val record = simulation.collisions?.record ?: return
        val row = LoggedCollision(simulation.step, record)
        for (k in 0 until record.size) {
            row.k = k
            CollisionColumns.rows.write(row, file.line())
            file.endLine()
        }
    }
}

/** Collision [k] in [record], the record of step [step]. */
internal class LoggedCollision(val step: Long, val record: CollisionRecord) {
    var k = 0
}

/** The columns of `collisions.csv`; `docs/guide.md` says what they mean. A further quantity is a further line here. */
public object CollisionColumns : TableColumns {
    internal val rows = Columns<LoggedCollision>("collisions.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    @JvmField
    public val STEP: Column = rows.whole("step") { it.step }

    @JvmField
    public val TIME_IN_STEP: Column = rows.number("time_in_step", Dimension.TIME) { it.record.time[it.k] }

    @JvmField
    public val ID_LOWER: Column = rows.whole("id_lower") { it.record.lower[it.k].toLong() }

    @JvmField
    public val ID_HIGHER: Column = rows.whole("id_higher") { it.record.higher[it.k].toLong() }

    @JvmField
    public val IMPACT_SPEED: Column = rows.number("impact_speed", Dimension.SPEED) { it.record.impactSpeed(it.k) }

    @JvmField
    public val COEFFICIENT: Column = rows.number("coefficient") { it.record.coefficient(it.k) }

    @JvmField
    public val IMPULSE: Column = rows.number("impulse", Dimension.MOMENTUM) { it.record.impulse(it.k) }

    @JvmField
    public val SEPARATION: List<Column> =
        rows.each(listOf("separation_x", "separation_y", "separation_z"), Dimension.LENGTH) { row, axis ->
            row.record.separation(row.k, axis)
        }
}
