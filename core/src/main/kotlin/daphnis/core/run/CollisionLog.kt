package daphnis.core.run

import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord
import daphnis.core.scenario.OutputSpec
import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.Need
import daphnis.core.table.TableColumns

/** The declaration of [CollisionLog]. A log cannot begin in the middle of a run, nor end there. */
internal object CollisionLogOutput : PeriodicOutput("collisions", OutputSpec::collisionLog) {
    private const val ROW_BYTES = 150

    override val tables: List<TableColumns> get() = listOf(CollisionColumns)
    override val readsCollisions: Boolean get() = true

    override fun mayChange(then: OutputTimes, now: OutputTimes): Boolean = then == now

    override fun cost(times: OutputTimes, course: Course, spheres: Int): OutputCost? =
        if (times.isNever) null else OutputCost("${CollisionColumns.file}, some $ROW_BYTES B per collision")

    override fun make(times: OutputTimes, sums: StepSums, files: RunFiles): Output? =
        if (times.isNever) null else CollisionLog(files, CollisionColumns.of(sums))
}

/**
 * `collisions.csv`: one row per collision, in time order. To put numbers into words takes most of the time of a log, so
 * the writer does that, from collisions that are held back until there are [many], or one has waited for a second.
 */
internal class CollisionLog(
    files: RunFiles,
    private val rows: Columns<LoggedCollision>,
    private val many: Int = MANY,
) : Output {
    private val file = files.table(rows)
    private var held = HeldCollisions()

    override fun write(simulation: Simulation) {
        if (simulation.step == 0L) return
        held.add(simulation.step, simulation.collisions?.record ?: return)
        if (held.size >= many || held.size > 0 && file.isDue()) handOver()
    }

    /** Before a checkpoint, which relies on all rows. */
    override fun save(state: OutputState): Unit = handOver()

    override fun close(): Unit = handOver()

    private fun handOver() {
        if (held.size == 0) return
        val row = LoggedCollision(held)
        held = HeldCollisions()
        file.handOver(row.held.bytes, row.held.size) { k, line ->
            row.k = k
            rows.write(row, line)
        }
    }

    private companion object {
        const val MANY = 1024
    }
}

/** Collisions of one step after the other. */
internal class HeldCollisions {
    val record = CollisionRecord()
    private val steps = ArrayList<Long>()
    private val ends = ArrayList<Int>()
    val size: Int get() = record.size
    val bytes: Long get() = size * (CollisionRecord.WIDTH + 1) * Double.SIZE_BYTES + 3L * size * Int.SIZE_BYTES

    fun add(step: Long, record: CollisionRecord) {
        val before = size
        for (k in 0 until record.size) if (!record.isWall(k)) this.record.addAll(record, k, k + 1)
        if (size == before) return
        steps += step
        ends += size
    }

    /** The step of collision [k]. */
    fun stepOf(k: Int): Long = steps[ends.binarySearch(k + 1).let { if (it < 0) -it - 1 else it }]
}

/** Collision [k] of [held]. */
internal class LoggedCollision(val held: HeldCollisions) {
    val record = held.record
    var k = 0
}

/**
 * The columns of `collisions.csv`. A further quantity is a further declaration here. [TANGENTIAL_IMPULSE] is only
 * there where spheres have spins, [EDGE] where they have interactions, and [SURFACE_DISSIPATION] in both, and where they
 * merge or break.
 */
public object CollisionColumns : TableColumns {
    internal val rows = Columns<LoggedCollision>("collisions.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    @JvmField
    public val STEP: Column = rows.whole(
        "step",
        "that it is part of; collisions with walls are not here",
        Need.NEEDED,
    ) { it.held.stepOf(it.k) }

    @JvmField
    public val TIME_IN_STEP: Column = rows.number(
        "time_in_step",
        "since the start of the step",
        Dimension.TIME,
        Need.NEEDED,
    ) { it.record.time[it.k] }

    @JvmField
    public val ID_LOWER: Column = rows.whole(
        "id_lower",
        "of the sphere with the lower id",
        Need.NEEDED,
    ) { it.record.lower[it.k].toLong() }

    @JvmField
    public val ID_HIGHER: Column = rows.whole(
        "id_higher",
        "of the other",
        Need.NEEDED,
    ) { it.record.higher[it.k].toLong() }

    @JvmField
    public val IMPACT_SPEED: Column = rows.number(
        "impact_speed",
        "normal component, before; below 0 at an edge where the two recede",
        Dimension.SPEED,
    ) { it.record.impactSpeed(it.k) }

    @JvmField
    public val COEFFICIENT: Column = rows.number(
        "coefficient",
        "of restitution, as applied; below 0 at an edge that is passed, 1 where they turn back",
    ) { it.record.coefficient(it.k) }

    @JvmField
    public val IMPULSE: Column = rows.number(
        "impulse",
        "momentum that changes hands along the normal; below 0 where an edge attracts",
        Dimension.MOMENTUM,
    ) { it.record.impulse(it.k) }

    @JvmField
    public val SEPARATION: List<Column> = rows.each(
        listOf("separation_x", "separation_y", "separation_z"),
        "from the lower to the higher sphere's centre, in contact or at the edge",
        Dimension.LENGTH,
    ) { row, axis ->
        row.record.separation(row.k, axis)
    }

    @JvmField
    public val TANGENTIAL_IMPULSE: List<Column> = rows.each(
        listOf("tangential_impulse_x", "tangential_impulse_y", "tangential_impulse_z"),
        "momentum that the higher sphere receives along its surface; only where spheres spin",
        Dimension.MOMENTUM,
    ) { row, axis -> row.record.tangentialImpulse(row.k, axis) }

    @JvmField
    public val SURFACE_DISSIPATION: Column = rows.number(
        "surface_dissipation",
        "energy, that of spins with it, that roughness takes, and a merger of the tangential motion; below 0 " +
            "what the pieces of spheres that break have of the impact; restitution takes ½ `impulse` (1 − " +
            "`coefficient`) `impact_speed` beside it; at an edge what a bridge takes; only where spheres spin, " +
            "have interactions, merge or break",
        Dimension.ENERGY,
    ) { it.record.surfaceDissipation(it.k) }

    @JvmField
    public val EDGE: Column = rows.whole(
        "edge",
        "0 where surfaces met; at an edge of an interaction 1 inward, 2 outward, 3 turned back; only where " +
            "spheres have one",
    ) { it.record.edge(it.k).toLong() }

    /** The columns of a run with [sums]. */
    internal fun of(sums: StepSums) = rows.without(
        (if (sums.haveSpins) emptySet() else TANGENTIAL_IMPULSE.toSet()) +
            (if (sums.haveEdges) emptySet() else setOf(EDGE)) +
            if (sums.haveSpins || !sums.arePlain) emptySet() else setOf(SURFACE_DISSIPATION),
    )
}
