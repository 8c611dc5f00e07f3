package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.hill.Epicycle
import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.Need
import daphnis.core.table.TableColumns

/** The source of a row of `bodies.csv`: the body at index [k] after a step of [simulation]. */
internal class BodyRow(val simulation: Simulation, val push: BodyPush, val k: Int) {
    val population = simulation.population

    /** Its epicycle; null without Hill's frame. */
    val orbit: Epicycle? = push.orbits?.let {
        val p = population
        Epicycle.of(p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k], it)
    }
}

/**
 * The columns of `bodies.csv`, a row for each body and time; `docs/guide.md` says what they mean. A further quantity
 * is a further line here.
 */
public object BodyColumns : TableColumns {
    internal val rows = Columns<BodyRow>("bodies.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    @JvmField
    public val STEP: Column = rows.whole("step") { it.simulation.step }

    @JvmField
    public val TIME: Column = rows.number("time", Dimension.TIME, Need.NEEDED) { it.simulation.time }

    /** Id of the body. */
    @JvmField
    public val BODY: Column = rows.whole("body", Need.NEEDED) { it.push.id.toLong() }

    @JvmField
    public val MASS: Column = rows.number("mass", Dimension.MASS, Need.NEEDED) { it.population.mass[it.k] }

    /** In the box. */
    @JvmField
    public val POSITION: List<Column> =
        rows.each(listOf("x", "y", "z"), Dimension.LENGTH) { row, axis -> row.population.position(axis)[row.k] }

    @JvmField
    public val VELOCITY: List<Column> =
        rows.each(listOf("vx", "vy", "vz"), Dimension.SPEED) { row, axis -> row.population.velocity(axis)[row.k] }

    /** X as if no face had been crossed: how far the semi-major axis has moved. */
    @JvmField
    public val GUIDING_X: Column =
        rows.number("guiding_x", Dimension.LENGTH, Need.NEEDED) { it.push.guidingX(it.simulation, it.k) }

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
        rows.number("gravity_push", Dimension.MOMENTUM, Need.NEEDED) { it.push.others(it.simulation, it.k) }
}
