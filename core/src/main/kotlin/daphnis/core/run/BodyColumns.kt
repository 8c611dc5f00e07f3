package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.format.Snapshot
import daphnis.core.hill.Epicycle
import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.Need
import daphnis.core.table.TableColumns
import java.nio.file.Path

/** The source of a row of `bodies.csv`: a body that has the [state] x y z v_x v_y v_z after a step of [simulation]. */
internal class BodyRow(val simulation: Simulation, val push: BodyPush, val state: DoubleArray) {
    /** Its epicycle; null without Hill's frame. */
    val orbit: Epicycle? = push.body.orbit(simulation)
}

/**
 * The columns of `bodies.csv`, a row for each body and time; `docs/columns.md` says what they mean. A further quantity
 * is a further line here. A satellite that feels the ring is a body too.
 */
public object BodyColumns : TableColumns {
    internal val rows = Columns<BodyRow>("bodies.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    /**
     * Elements and time of the satellites that feel the ring at [state], by the number of their rows, as the file at
     * [path] has them.
     */
    internal fun satellites(path: Path, state: Snapshot): Map<Int, List<Double>> {
        val elements = listOf(GUIDING_X, GUIDING_Y, ECCENTRICITY, PHASE, INCLINATION, VERTICAL_PHASE, TIME)
        return RowsOfState.read(path, state, TIME).mapNotNull { row ->
            val id = row[BODY]?.toInt()?.takeIf { it < 0 } ?: return@mapNotNull null
            elements.map { row[it] ?: return@mapNotNull null }.let { id to it }
        }.toMap()
    }

    @JvmField
    public val STEP: Column = rows.whole("step") { it.simulation.step }

    @JvmField
    public val TIME: Column = rows.number("time", Dimension.TIME, Need.NEEDED) { it.simulation.time }

    /** Id of the body; of a satellite that feels the ring, −1 for the first of all, −2 for the second. */
    @JvmField
    public val BODY: Column = rows.whole("body", Need.NEEDED) { it.push.body.id.toLong() }

    @JvmField
    public val MASS: Column = rows.number("mass", Dimension.MASS, Need.NEEDED) { it.push.body.mass(it.simulation) }

    /** In the box. */
    @JvmField
    public val POSITION: List<Column> =
        rows.each(listOf("x", "y", "z"), Dimension.LENGTH) { row, axis -> row.state[axis] }

    @JvmField
    public val VELOCITY: List<Column> =
        rows.each(listOf("vx", "vy", "vz"), Dimension.SPEED) { row, axis -> row.state[3 + axis] }

    /** X as if no face had been crossed: how far the semi-major axis has moved. */
    @JvmField
    public val GUIDING_X: Column =
        rows.number("guiding_x", Dimension.LENGTH, Need.NEEDED) { it.push.body.guidingX(it.simulation) }

    /** Y in the box. */
    @JvmField
    public val GUIDING_Y: Column =
        rows.number("guiding_y", Dimension.LENGTH) { it.orbit?.guidingY ?: Double.NaN }

    /** Eccentricity times semi-major axis. */
    @JvmField
    public val ECCENTRICITY: Column = rows.number("e", Dimension.LENGTH) { it.orbit?.e ?: Double.NaN }

    @JvmField
    public val PHASE: Column = rows.number("phase") { it.orbit?.phase ?: Double.NaN }

    /** Inclination times semi-major axis. */
    @JvmField
    public val INCLINATION: Column = rows.number("i", Dimension.LENGTH) { it.orbit?.i ?: Double.NaN }

    @JvmField
    public val VERTICAL_PHASE: Column = rows.number("vertical_phase") { it.orbit?.verticalPhase ?: Double.NaN }

    /** Impacts since the row before. */
    @JvmField
    public val IMPACTS: Column = rows.whole("impacts") { it.push.count }

    /** Push along the orbit by impacts since the row before: times the distance from the planet, angular momentum. */
    @JvmField
    public val IMPACT_PUSH: Column = rows.number("impact_push", Dimension.MOMENTUM, Need.NEEDED) { it.push.impacts }

    /** The same by everything else, which is gravity. */
    @JvmField
    public val GRAVITY_PUSH: Column =
        rows.number("gravity_push", Dimension.MOMENTUM, Need.NEEDED) { it.push.others(it.simulation) }
}
