package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.population.Bonds
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns

internal const val NOWHERE = -1

/** Takes over the spheres of [population] at the indices `order[slot]`, at the start of a step, for the slots [from] until [to]. */
internal fun StepRows.loadRange(population: SphereColumns, order: IntArray, from: Int, to: Int) {
    val state = state
    val x = population.x
    val y = population.y
    val z = population.z
    val vx = population.vx
    val vy = population.vy
    val vz = population.vz
    val r = population.radius
    var p = from * STRIDE
    for (slot in from until to) {
        val k = order[slot]
        state[p] = x[k]
        state[p + 1] = y[k]
        state[p + 2] = z[k]
        state[p + VX] = vx[k]
        state[p + VX + 1] = vy[k]
        state[p + VX + 2] = vz[k]
        state[p + TIME] = 0.0
        state[p + RADIUS] = r[k]
        p += STRIDE
    }
    val ids = population.id
    for (slot in from until to) {
        val k = order[slot]
        id[slot] = ids[k]
        origin[slot] = k
    }
    marks.fill(0, from * StepRows.MARKS, to * StepRows.MARKS)
    for (side in carried) {
        val own = side(side)
        val column = population.column(side)
        for (slot in from until to) own[slot] = column[order[slot]]
    }
    if (population.bonds !== Bonds.NONE) for (slot in from until to) bonds[slot] = population.bonds[order[slot]]
}

/** Writes the slots [from] until [to], at the end of a step of [duration], to the same entries of [columns]. */
internal fun StepRows.storeRange(columns: PopulationColumns, duration: Double, from: Int, to: Int) {
    storeStates(columns, duration, from, to) { it }
    for (side in carried) storeSide(side, columns, duration, from, to) { it }
    storeBonds(columns, from, to) { it }
    id.copyInto(columns.id, from, from, to)
}

/**
 * Moves the spheres whose [StepRows.origin] is [chosen] to the end of a step of [duration] and writes them, in the order
 * of their slots, to entries [at], [at] + 1, … of [columns]. Other spheres are left out.
 *
 * @return how many were written
 */
internal inline fun StepRows.storeWhere(
    columns: PopulationColumns,
    at: Int,
    duration: Double,
    chosen: (origin: Int) -> Boolean,
): Int {
    var next = at
    storeStates(columns, duration, 0, size) { if (chosen(origin[it])) next++ else NOWHERE }
    var k = at
    for (slot in 0 until size) if (chosen(origin[slot])) columns.id[k++] = id[slot]
    for (side in carried) {
        k = at
        storeSide(side, columns, duration, 0, size) { if (chosen(origin[it])) k++ else NOWHERE }
    }
    k = at
    storeBonds(columns, 0, size) { if (chosen(origin[it])) k++ else NOWHERE }
    return next - at
}

/**
 * Moves all spheres to the end of a step of [duration] and writes what collisions have changed of each to the entry of
 * [columns] that [places] gives for its slot.
 */
internal fun StepRows.storeAt(columns: PopulationColumns, duration: Double, places: IntArray) {
    storeStates(columns, duration, 0, size) { places[it] }
    for (side in changing) storeSide(side, columns, duration, 0, size) { places[it] }
    storeBonds(columns, 0, size) { places[it] }
}

/** Writes the partners of the slots [from] until [to], where there are any, each to the entry that [place] says. */
internal inline fun StepRows.storeBonds(columns: PopulationColumns, from: Int, to: Int, place: (Int) -> Int) {
    if (columns.bonds === Bonds.NONE) return
    for (slot in from until to) {
        val k = place(slot)
        if (k != NOWHERE) columns.bonds[k] = bonds[slot]
    }
}

/** Writes the column [side], which is not in the packed rows, of the slots [from] until [to]. */
internal inline fun StepRows.storeSide(
    side: Int,
    columns: PopulationColumns,
    duration: Double,
    from: Int,
    to: Int,
    place: (Int) -> Int,
) {
    val own = side(side)
    val out = columns.column(side)
    val passed = RowColumns.passed(side, duration)
    for (slot in from until to) {
        val k = place(slot)
        if (k != NOWHERE) out[k] = own[slot] - passed
    }
}

/** Writes positions, velocities and radii of the slots [from] until [to], each to the entry that [place] says. */
internal inline fun StepRows.storeStates(
    columns: PopulationColumns,
    duration: Double,
    from: Int,
    to: Int,
    place: (Int) -> Int,
) {
    val state = state
    val x = columns.x
    val y = columns.y
    val z = columns.z
    val vx = columns.vx
    val vy = columns.vy
    val vz = columns.vz
    val r = columns.radius
    var p = from * STRIDE
    for (slot in from until to) {
        val k = place(slot)
        if (k != NOWHERE) {
            val rest = duration - state[p + TIME]
            val u = state[p + VX]
            val v = state[p + VX + 1]
            val w = state[p + VX + 2]
            x[k] = state[p] + u * rest
            y[k] = state[p + 1] + v * rest
            z[k] = state[p + 2] + w * rest
            vx[k] = u
            vy[k] = v
            vz[k] = w
            r[k] = state[p + RADIUS]
        }
        p += STRIDE
    }
}
