package daphnis.core.cluster.bricks

import daphnis.core.engine.horizon.Visits
import daphnis.core.growth.IntList
import daphnis.core.population.Bonds
import daphnis.core.population.ColumnSets
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.optional

/**
 * The spheres with which a brick computes, copied: its own and those of its halo, as they are at the start of the step.
 * They are gathered anew for each step: [begin] forgets all before, [goOn] leaves each where it was, so that what was
 * found out about it by its place holds. A sphere that is not gathered again is away then, and keeps its place for the
 * case that it comes back; see [isHere].
 */
internal class BrickSpheres :
    SphereColumns,
    Visits {
    override var size = 0
        private set

    /** Places for which there is room. */
    private var room = 0

    /** In all sets of columns entries beyond [size] are room for more. */
    var sets = ColumnSets(PopulationColumns(0))
        private set
    override val id: IntArray get() = sets.now.id

    override fun column(place: Int): DoubleArray = sets.now.column(place)

    override val bonds: Array<IntArray> get() = sets.now.bonds

    /** By place: the number of the last step in which the sphere was there. */
    private var seen = LongArray(0)
    private var isOwn = BooleanArray(0)
    private var step = 1L

    /** Number of spheres that the brick owns, and places of those of its halo. */
    var own = 0
        private set
    val near = IntList()
    override val entered = IntList()
    override val left = IntList()

    /** Where spheres are, by id; filled when somebody asks for the first time since they have their places. */
    private val places = IdIndex()
    private var isIndexed = false

    /** Whether all spheres of the last step that was begun have been added. */
    var isSettled = false
        private set

    /** Whether spheres have the places that they had in the step before. */
    var keepsPlaces = false
        private set

    /** The place of the sphere that was gathered last: nearly always the next one is beside it. */
    private var last = -1

    /** Spheres that have come since [begin], those that came back not counted. */
    private var guests = 0

    /** Whether so many have come that places are to be given anew. */
    var areTooMany = false
        private set

    /** Number of spheres that are there. */
    val here: Int get() = own + near.size

    fun isOwn(k: Int): Boolean = isOwn[k] && isHere(k)

    override fun isHere(slot: Int): Boolean = seen[slot] == step

    /** Begins a step of [count] spheres, which get places in the order in which they are added. */
    fun begin(count: Int) {
        isSettled = false
        if (room < count) enlarge(count)
        size = 0
        keepsPlaces = false
        isIndexed = false
        guests = 0
        start()
    }

    /** Begins a step whose spheres are nearly those of the step before, which is settled, and keep their places. */
    fun goOn() {
        keepsPlaces = true
        start()
    }

    private fun start() {
        isSettled = false
        step++
        own = 0
        near.clear()
        entered.clear()
        left.clear()
        last = -1
        areTooMany = false
    }

    private fun enlarge(count: Int) {
        val n = count + count / MOST_GUESTS + 1
        room = 0
        seen = LongArray(n)
        isOwn = BooleanArray(n)
        sets = ColumnSets(PopulationColumns(n, optional))
        // Assigned last, since it says how many spheres there is room for: an allocation before it may have failed.
        room = n
    }

    /** Adds the entries [indices] of [spheres], which the brick owns or has in its halo. */
    fun add(spheres: SphereColumns, indices: IndexRuns, areOwn: Boolean) {
        if (indices.runs > 0) takeKind(spheres)
        for (run in 0 until indices.runs) {
            if (keepsPlaces) {
                put(spheres, indices.from(run), indices.to(run), areOwn)
            } else {
                append(spheres, indices.from(run), indices.to(run), areOwn)
            }
        }
    }

    /** Spheres have spins and materials from now on, if [spheres] have. */
    private fun takeKind(spheres: SphereColumns) {
        val own = optional
        val all = own or spheres.optional
        if (all != own) sets = ColumnSets(sets.now.having(all))
    }

    private fun append(spheres: SphereColumns, from: Int, to: Int, areOwn: Boolean) {
        for (place in SphereQuantity.present(optional)) spheres.column(place).copyInto(column(place), size, from, to)
        spheres.id.copyInto(id, size, from, to)
        if (spheres.bonds !== Bonds.NONE) spheres.bonds.copyInto(bonds, size, from, to)
        val end = size + to - from
        seen.fill(step, size, end)
        isOwn.fill(areOwn, size, end)
        if (areOwn) own += to - from else for (k in size until end) near.add(k)
        size = end
    }

    /** Spheres that follow one another there mostly do so here too, and are copied together. */
    private fun put(spheres: SphereColumns, from: Int, to: Int, areOwn: Boolean) {
        var index = from
        while (index < to) {
            val k = placeOf(spheres.id[index])
            if (k < 0) return
            var count = 1
            while (index + count < to && k + count < size && id[k + count] == spheres.id[index + count]) count++
            for (place in SphereQuantity.present(optional)) {
                spheres.column(place).copyInto(column(place), k, index, index + count)
            }
            if (spheres.bonds !== Bonds.NONE) spheres.bonds.copyInto(bonds, k, index, index + count)
            for (slot in k until k + count) {
                if (seen[slot] != step - 1) entered.add(slot)
                if (!areOwn) near.add(slot)
            }
            seen.fill(step, k, k + count)
            isOwn.fill(areOwn, k, k + count)
            if (areOwn) own += count
            last = k + count - 1
            index += count
        }
    }

    /** The place of [sphere], a new one when there is none; −1 when there are too many. */
    private fun placeOf(sphere: Int): Int {
        for (k in last + 1..minOf(last + BESIDE, size - 1)) if (id[k] == sphere) return k
        if (!isIndexed) {
            places.clear(size + size / MOST_GUESTS + 1)
            for (k in 0 until size) places.put(id[k], k)
            isIndexed = true
        }
        val known = places.find(sphere)
        if (known >= 0) return known
        if (size == room || guests > size / MOST_GUESTS) {
            areTooMany = true
            return -1
        }
        guests++
        id[size] = sphere
        seen[size] = 0
        places.put(sphere, size)
        return size++
    }

    /** All have been added. */
    fun settle() {
        if (keepsPlaces) for (k in 0 until size) if (seen[k] == step - 1) left.add(k)
        isSettled = true
    }

    /** Calls [use] with the place of each sphere that the brick owns. */
    inline fun forEachOwn(use: (k: Int) -> Unit) {
        for (k in 0 until size) if (isOwn(k)) use(k)
    }

    private companion object {
        /** One part in so many may be spheres that came later. */
        const val MOST_GUESTS = 4

        /** Places that are looked at before the index is. */
        const val BESIDE = 4
    }
}
