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
 * The columns of `bodies.csv`, a row for each body and time. A further quantity is a further declaration here. A
 * satellite that feels the ring is a body too.
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
    public val STEP: Column = rows.step { it.simulation.step }

    @JvmField
    public val TIME: Column = rows.time { it.simulation.time }

    @JvmField
    public val BODY: Column = rows.whole(
        "body",
        "its id; of a satellite that feels the ring −1 for the first of all satellites, −2 for the second",
        Need.NEEDED,
    ) { it.push.body.id.toLong() }

    @JvmField
    public val MASS: Column = rows.number(
        "mass",
        "of the body",
        Dimension.MASS,
        Need.NEEDED,
    ) { it.push.body.mass(it.simulation) }

    @JvmField
    public val POSITION: List<Column> = rows.each(
        listOf("x", "y", "z"),
        "its centre, in the box",
        Dimension.LENGTH,
    ) { row, axis -> row.state[axis] }

    @JvmField
    public val VELOCITY: List<Column> = rows.each(
        listOf("vx", "vy", "vz"),
        "its velocity",
        Dimension.SPEED,
    ) { row, axis -> row.state[3 + axis] }

    @JvmField
    public val GUIDING_X: Column = rows.number(
        "guiding_x",
        "X = (4x + 2 v_y/Ω) (Ω/κ)², counted through the faces: how far its semi-major axis has moved",
        Dimension.LENGTH,
        Need.NEEDED,
    ) { it.push.body.guidingX(it.simulation) }

    @JvmField
    public val GUIDING_Y: Column = rows.number(
        "guiding_y",
        "Y = y − 2 v_x Ω/κ², in the box",
        Dimension.LENGTH,
    ) { it.orbit?.guidingY ?: Double.NaN }

    @JvmField
    public val ECCENTRICITY: Column = rows.number(
        "e",
        "eccentricity times semi-major axis",
        Dimension.LENGTH,
    ) { it.orbit?.e ?: Double.NaN }

    @JvmField
    public val PHASE: Column = rows.number(
        "phase",
        "of the epicycle, radians, 0 at pericentre",
    ) { it.orbit?.phase ?: Double.NaN }

    @JvmField
    public val INCLINATION: Column = rows.number(
        "i",
        "inclination times semi-major axis",
        Dimension.LENGTH,
    ) { it.orbit?.i ?: Double.NaN }

    @JvmField
    public val VERTICAL_PHASE: Column = rows.number(
        "vertical_phase",
        "ζ of z = i cos ζ, radians",
    ) { it.orbit?.verticalPhase ?: Double.NaN }

    @JvmField
    public val IMPACTS: Column = rows.whole(
        "impacts",
        "since the row before, or the start of the run, as both pushes",
    ) { it.push.count }

    @JvmField
    public val IMPACT_PUSH: Column = rows.number(
        "impact_push",
        "push along the orbit by these impacts; times the distance from the planet it is angular momentum",
        Dimension.MOMENTUM,
        Need.NEEDED,
    ) { it.push.impacts }

    @JvmField
    public val GRAVITY_PUSH: Column = rows.number(
        "gravity_push",
        "that by all else: gravity of the ring, of other bodies, of satellites",
        Dimension.MOMENTUM,
        Need.NEEDED,
    ) { it.push.others(it.simulation) }
}
