package daphnis.core.engine.lists

import daphnis.core.boundary.Images
import daphnis.core.collision.StepRows
import daphnis.core.collision.contactTime
import daphnis.core.step.PreparedStep

/**
 * The spheres of a step that is taken with lists, by slot, and how they are divided among regions: each has as many
 * slots one after the other, which lie side by side in space ([SpaceOrder]).
 */
internal class ListField(val prepared: PreparedStep) {
    /** The spheres as they are. A region writes its own. */
    val rows = StepRows()

    /** As they were when the present window of the step began, for other regions; not in use where there is one. */
    val before = StepRows()
    val space = ListSpace()
    val lists = NeighbourLists(this)
    val events = EventTable()
    val images: Images get() = prepared.images

    /** Number of spheres, and of regions. */
    var size = 0
        private set
    var regions = 1
        private set
    var slotsARegion = 1
        private set

    val isShared: Boolean get() = regions > 1

    /** By slot, in the present window: whether the region of a sphere leaves it alone. */
    var isFrozen = BooleanArray(0)
        private set

    /** By slot: whether a sphere has, or has had, spheres of other regions in its list. */
    var isAtBorder = BooleanArray(0)
        private set

    /** Divides [spheres] among [regions]. */
    fun divide(spheres: Int, regions: Int) {
        size = spheres
        if (regions > 1 && isFrozen.size < spheres) {
            isAtBorder = BooleanArray(spheres)
            isFrozen = BooleanArray(spheres)
        }
        isFrozen.fill(false)
        isAtBorder.fill(false)
        slotsARegion = (spheres - 1) / regions + 1
        this.regions = (spheres - 1) / slotsARegion + 1
    }

    fun firstOf(region: Int): Int = region * slotsARegion

    fun endOf(region: Int): Int = minOf((region + 1) * slotsARegion, size)

    fun regionOf(slot: Int): Int = slot / slotsARegion

    /** The sphere in [slot] has a path that everybody sees from now on. */
    fun settle(slot: Int) {
        before.put(slot, rows, slot)
        events.settle(slot)
    }

    /** The sphere in [slot] is as it was when the window began. */
    fun restore(slot: Int) {
        rows.put(slot, before, slot)
        events.setOut(slot, false)
        // Not the version that it had: what was found on the path that it has left must not seem to hold.
        events.bend(slot)
    }
}

/**
 * What one region sees: its own spheres, from slot [first] until [end], as they are, and all others as they were when
 * the window began, since only their own region may write what they do now.
 */
internal class ListSight(private val field: ListField) {
    var first = 0
        private set
    var end = 0
        private set

    fun see(first: Int, end: Int) {
        this.first = first
        this.end = end
    }

    fun owns(slot: Int): Boolean = slot >= first && slot < end

    fun rowsOf(slot: Int): StepRows = if (owns(slot)) field.rows else field.before

    fun version(slot: Int): Int = if (owns(slot)) field.events.version(slot) else field.events.settled(slot)

    /** The [contactTime] of an own sphere with another, at its image [code]. */
    fun contactTime(own: Int, other: Int, code: Int): Double = contactTime(
        field.rows.state,
        own * StepRows.STRIDE,
        rowsOf(other).state,
        other * StepRows.STRIDE,
        code,
        field.images,
    )
}
