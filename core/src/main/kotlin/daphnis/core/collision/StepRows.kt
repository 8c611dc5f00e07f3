package daphnis.core.collision

import daphnis.core.api.EngineApi
import daphnis.core.growth.GrowingTable
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Bonds
import daphnis.core.population.Population
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.optional

/**
 * The population during one step: a packed copy in cell order with eight doubles per sphere. A sphere in a collision is
 * one or two cache lines, and a cell is one contiguous stretch of memory. **Slot** s is the place of a sphere in this
 * order and does not change within the step. Entry `s·8 + k` of [state] is
 *
 * | k | 0 1 2 | 3 4 5 | 6 | 7 |
 * |---|---|---|---|---|
 * | | x y z | vx vy vz | local time, from the start of the step | radius |
 *
 * A sphere's position and velocity are those at its **local time**; both change only at its own collisions. The arrays
 * of the population are not written, so a step can be redone from them. [store] writes to a second set.
 */
@EngineApi
public class StepRows : GrowingTable() {
    /** See the table above. */
    public var state: DoubleArray = DoubleArray(0)
        private set

    /** Columns by place that are not in [state]. */
    private val sides = Array(SphereQuantity.WIDTH) { DoubleArray(0) }

    /** Whether this step carries the times of collisions. */
    internal var tracksLastCollision: Boolean = false
        private set

    /** Whether spheres have angular velocities. */
    public val hasSpin: Boolean get() = optional and SPINNING != 0

    /** Whether it is known what spheres are made of. */
    internal val hasMaterials: Boolean get() = optional and MADE != 0

    /** The set of optional quantities that spheres have, see [SphereQuantity.of]. */
    internal var optional: Int = 0
        private set

    /** Places of the columns besides [state] that this step carries. */
    internal var carried: IntArray = RowColumns.LEAST
        private set

    /** Places of those that collisions change. */
    internal var changing: IntArray = RowColumns.changing(tracks = false, optional = 0)
        private set

    /** Whether collisions change masses too, as spheres merge; to be said before spheres are taken over. */
    internal var changesMass: Boolean = false

    /** Partners of each sphere and the states of the pairs by slot, see [Bonds]; empty where pairs have none. */
    internal var bonds: Array<IntArray> = Bonds.NONE
        private set

    /** Whether this step carries [bonds]. */
    private val hasBonds: Boolean get() = optional and SphereQuantity.BONDED != 0

    /** The column at [place], which is not in [state], by slot. */
    internal fun side(place: Int): DoubleArray = sides[place]

    /** Mass by slot. */
    public val mass: DoubleArray get() = sides[MASS]

    /** Stable id by slot. */
    public var id: IntArray = IntArray(0)
        private set

    /** Index in the population before the step, by slot. */
    public var origin: IntArray = IntArray(0)
        private set

    /**
     * Time of the last collision by slot, counted from the start of this step (≤ 0 when it lies before); −∞ when there
     * was none.
     */
    public val lastCollision: DoubleArray get() = sides[LAST_COLLISION]

    /** Angular velocities by slot, in the axes of the start of the step; likewise [wy], [wz]. */
    internal val wx: DoubleArray get() = sides[SPIN]
    internal val wy: DoubleArray get() = sides[SPIN + 1]
    internal val wz: DoubleArray get() = sides[SPIN + 2]

    /** Numbers of materials by slot, where there are any. */
    internal val material: DoubleArray get() = sides[MATERIAL]

    /** Two numbers per slot, [rank] and [streak], which lie side by side since a collision changes both. */
    internal var marks: IntArray = IntArray(0)
        private set

    /** Consecutive collisions of one sphere which are no farther apart in time than this belong to one [streak]. */
    private var resolution = 0.0

    /**
     * Place of the sphere's last collision among those at its local time that led to one another. It is 1 when no other
     * collision at that time led to this one; otherwise it is one more than the higher rank of its two spheres. It is 0
     * when the sphere has not collided at its local time.
     */
    public fun rank(slot: Int): Int = marks[slot * MARKS]

    /**
     * How many collisions, with spheres and walls, the sphere in [slot] has had in a row while time stood still: each
     * at most 1e-13 of the step after the one before. It follows from the sphere's own path, so it is the same for
     * every engine.
     */
    public fun streak(slot: Int): Int = marks[slot * MARKS + 1]

    /**
     * Takes over [population] in the given [order] (index by slot) for a step of [duration]; every local time is 0.
     * Allocates only when the population grew.
     */
    @JvmOverloads
    public fun load(
        population: SphereColumns,
        order: IntArray,
        duration: Double,
        tracksLastCollision: Boolean,
        loop: RangeLoop = InlineLoop,
    ) {
        reserve(population.size)
        size = population.size
        resolution = duration * RESOLUTION
        carry(tracksLastCollision, population.optional)
        loop.run(size) { _, from, to -> loadRange(population, order, from, to) }
    }

    /** From now on columns are carried for notes of collisions, or not, and for the quantities of [optional]. */
    private fun carry(tracks: Boolean, optional: Int) {
        val carried = RowColumns.carried(tracks, optional)
        reserveSides(carried, room)
        tracksLastCollision = tracks
        this.optional = optional
        reserveBonds(room)
        changing = RowColumns.changing(tracks, optional)
        if (changesMass) changing += MASS
        this.carried = carried
    }

    private fun reserveSides(places: IntArray, room: Int) {
        for (side in places) if (sides[side].size < room) sides[side] = sides[side].copyOf(room)
    }

    private fun reserveBonds(room: Int) {
        if (!hasBonds || bonds.size >= room) return
        val before = bonds
        bonds = Array(room) { if (it < before.size) before[it] else Bonds.FREE }
    }

    /**
     * Moves every sphere to the end of a step of [duration] and writes all to new arrays of [population], where index k
     * is slot k from now on. When this throws, the population is as it was. Allocates at the first store, and when the
     * population has lost spheres.
     */
    @JvmOverloads
    public fun store(population: Population, duration: Double, loop: RangeLoop = InlineLoop) {
        val columns = population.columnsToWrite(tracksLastCollision)
        loop.run(size) { _, from, to -> storeRange(columns, duration, from, to) }
        population.take(columns)
    }

    /** Removes all rows, for a step of [duration] of which some spheres are to be [included][include]. */
    internal fun begin(duration: Double, tracksLastCollision: Boolean, optional: Int) {
        size = 0
        resolution = duration * RESOLUTION
        carry(tracksLastCollision, optional)
    }

    /** Appends the sphere at [index] of [population], at the start of the step, and returns its slot. */
    internal fun include(population: SphereColumns, index: Int): Int {
        val k = append()
        copyState(population, index, state, k * STRIDE)
        for (side in carried) sides[side][k] = population.column(side)[index]
        if (hasBonds) bonds[k] = population.bonds[index]
        id[k] = population.id[index]
        origin[k] = index
        marks.fill(0, k * MARKS, (k + 1) * MARKS)
        return k
    }

    /**
     * Appends a copy of row [slot] of [rows] with everything that belongs to it, and returns its place here. Allocates
     * when full.
     */
    public fun take(rows: StepRows, slot: Int): Int {
        val k = append()
        if (carried !== rows.carried || changesMass != rows.changesMass) {
            changesMass = rows.changesMass
            carry(rows.tracksLastCollision, rows.optional)
        }
        resolution = rows.resolution
        rows.state.copyInto(state, k * STRIDE, slot * STRIDE, (slot + 1) * STRIDE)
        for (side in carried) sides[side][k] = rows.sides[side][slot]
        if (hasBonds) bonds[k] = rows.bonds[slot]
        id[k] = rows.id[slot]
        origin[k] = rows.origin[slot]
        rows.marks.copyInto(marks, k * MARKS, slot * MARKS, (slot + 1) * MARKS)
        return k
    }

    /** Takes over the state of row [k] of [rows] as that of [slot]. */
    public fun put(slot: Int, rows: StepRows, k: Int) {
        rows.state.copyInto(state, slot * STRIDE, k * STRIDE, (k + 1) * STRIDE)
        rows.marks.copyInto(marks, slot * MARKS, k * MARKS, (k + 1) * MARKS)
        for (side in changing) sides[side][slot] = rows.sides[side][k]
        if (hasBonds) bonds[slot] = rows.bonds[k]
    }

    /** Moves [slot] along its path to its collision at [time], from the start of the step. */
    internal fun advance(slot: Int, time: Double) {
        val p = slot * STRIDE
        val elapsed = time - state[p + TIME]
        state[p] += state[p + VX] * elapsed
        state[p + 1] += state[p + VX + 1] * elapsed
        state[p + 2] += state[p + VX + 2] * elapsed
        state[p + TIME] = time
        if (elapsed != 0.0) marks[slot * MARKS] = 0
        if (elapsed > resolution) marks[slot * MARKS + 1] = 1 else marks[slot * MARKS + 1]++
    }

    override fun resize(room: Int) {
        state = state.copyOf(room * STRIDE)
        reserveSides(NEEDED, room)
        reserveSides(carried, room)
        reserveBonds(room)
        id = id.copyOf(room)
        origin = origin.copyOf(room)
        marks = marks.copyOf(room * MARKS)
    }

    public companion object {
        /** Places of the columns that all rows have room for. */
        private val NEEDED = RowColumns.carried(tracks = true, optional = 0)
        private val MASS = SphereQuantity.MASS.place
        private val SPIN = SphereQuantity.SPIN.place
        private val MATERIAL = SphereQuantity.MATERIAL.place
        private val SPINNING = SphereQuantity.SPIN.bit
        private val MADE = SphereQuantity.MATERIAL.bit
        private val LAST_COLLISION = SphereQuantity.LAST_COLLISION.place

        /** Numbers per sphere in [marks]. */
        internal const val MARKS: Int = 2

        /** As a fraction of a step: some hundred times the rounding of times at its end. */
        private const val RESOLUTION = 1e-13

        /** Writes the [state], at the start of a step, of the sphere at [index] of [population] to [into], from [p] on. */
        internal fun copyState(population: SphereColumns, index: Int, into: DoubleArray, p: Int) {
            into[p] = population.x[index]
            into[p + 1] = population.y[index]
            into[p + 2] = population.z[index]
            into[p + VX] = population.vx[index]
            into[p + VX + 1] = population.vy[index]
            into[p + VX + 2] = population.vz[index]
            into[p + TIME] = 0.0
            into[p + RADIUS] = population.radius[index]
        }

        /** Doubles per sphere in [state]. */
        public const val STRIDE: Int = 8

        /** Offset of the velocity in a row. */
        public const val VX: Int = 3

        /** Offset of the local time in a row. */
        public const val TIME: Int = 6

        /**
         * The local time of a sphere whose path is known elsewhere only, because an island has a copy of it. The rest
         * of its row is out of date. Every time that is computed from it is [UNKNOWN] too, which is NaN: no comparison
         * with it holds, so it is asked for by [isUnknown].
         */
        public const val UNKNOWN: Double = Double.NaN

        /** Whether [time] is that of a sphere which is [UNKNOWN], or was computed from it. */
        @JvmStatic
        public fun isUnknown(time: Double): Boolean = time.isNaN()

        /** Offset of the radius in a row. */
        public const val RADIUS: Int = 7
    }
}
