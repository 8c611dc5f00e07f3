package daphnis.core.engine.horizon

import daphnis.core.collision.RowColumns
import daphnis.core.growth.IntList
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.isFinite
import daphnis.core.population.optional
import daphnis.core.search.StepBounds

/**
 * The one pass over all spheres of a step: it writes each where it is at the end of the step if it does not collide,
 * and finds those which have left their lines. Nothing else has to say what it has changed: whether a sphere was
 * kicked, wrapped or moved by hand shows by its place at the start and at the end of its path.
 *
 * A sphere whose place at both ends of the step is within [EpochFrame.deviation] of its line is within it in between
 * too, since both are straight.
 */
internal class Passage(private val space: EpochSpace, private val loop: RangeLoop) {
    private val frame = space.frame
    private val lines = space.lines

    /** Slots of the spheres which have left their lines, in order. */
    val changed = IntList()

    /** What one worker has found. */
    private class Strays {
        val slots = IntList()

        /** Whether all numbers of these spheres are finite. */
        var areFinite = true
    }

    private val found = List(loop.workers) { Strays() }

    /** Whether a sphere is larger than its line has it, or so many have left that nobody needs to look further. */
    @Volatile
    private var isOver = false
    private var most = 0

    /** The first step of an epoch: puts spheres into the order of [cells] and gives each its line. */
    fun first(population: SphereColumns, cells: EpochCells, columns: PopulationColumns) {
        lines.begin(population.size)
        if (space.isShared) space.before.begin(population.size)
        changed.clear()
        loop.run(population.size) { _, from, to -> first(population, cells, columns, from, to) }
    }

    private fun first(p: SphereColumns, cells: EpochCells, columns: PopulationColumns, from: Int, to: Int) {
        val order = cells.order
        val dt = frame.duration
        for (slot in from until to) {
            val k = order[slot]
            val u = p.vx[k]
            val v = p.vy[k]
            val w = p.vz[k]
            columns.x[slot] = p.x[k] + u * dt
            columns.y[slot] = p.y[k] + v * dt
            columns.z[slot] = p.z[k] + w * dt
            columns.vx[slot] = u
            columns.vy[slot] = v
            columns.vz[slot] = w
            columns.radius[slot] = p.radius[k]
            columns.id[slot] = p.id[k]
            lines.putRadius(slot, p.radius[k])
            lines.put(slot, p.x[k], p.y[k], p.z[k], u, v, w, 0.0)
            lines.moveBack(slot, cells.imageAtStart(slot))
        }
        for (place in RowColumns.fixed(p.optional)) {
            val column = p.column(place)
            val its = columns.column(place)
            for (slot in from until to) its[slot] = column[order[slot]]
        }
    }

    /** A later window of a step: gives each sphere its line anew. [columns] say where it is at the end of the step. */
    fun again(columns: SphereColumns, cells: EpochCells) {
        lines.begin(columns.size)
        if (space.isShared) space.before.begin(columns.size)
        loop.run(columns.size) { _, from, to -> again(columns, cells, from, to) }
    }

    private fun again(p: SphereColumns, cells: EpochCells, from: Int, to: Int) {
        val order = cells.order
        for (slot in from until to) {
            val k = order[slot]
            lines.putRadius(slot, p.radius[k])
            lines.put(slot, p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k], frame.duration)
            lines.moveBack(slot, cells.imageAtStart(slot))
        }
    }

    /**
     * Writes what is not in the lines of spheres that do not collide in this step. [order] is their index in
     * [population]; null when it is the same.
     *
     * @param tracks whether collisions note their times
     */
    fun keep(population: SphereColumns, columns: PopulationColumns, order: IntArray?, tracks: Boolean) {
        for (place in RowColumns.changing(tracks, population.optional)) {
            val from = population.column(place)
            val to = columns.column(place)
            val passed = RowColumns.passed(place, frame.duration)
            loop.runLight(population.size) { _, first, end ->
                for (k in first until end) to[k] = from[if (order == null) k else order[k]] - passed
            }
        }
    }

    /**
     * A later step, in which slots are indices of [population]: gives what is to look at all of them. [hasNext] follows.
     */
    fun next(population: SphereColumns, columns: PopulationColumns): StepBounds.AlongPieces {
        changed.clear()
        isOver = false
        for (strays in found) {
            strays.slots.clear()
            strays.areFinite = true
        }
        most = population.size / PART + FEW
        return StepBounds.AlongPieces { worker, from, to ->
            val isFinite = !isOver && pass(population, columns, from, to, found[worker])
            if (found[worker].slots.size > most) isOver = true
            isFinite
        }
    }

    /** @return false when so many have left their lines, or a sphere has grown, that a new epoch is due */
    fun hasNext(): Boolean {
        if (isOver || found.sumOf { it.slots.size } > most) return false
        for (strays in found) changed.addAll(strays.slots)
        if (found.size > 1) changed.sort()
        return true
    }

    /** @return whether all numbers of these spheres are finite: those of spheres on their lines cannot but be */
    private fun pass(
        population: SphereColumns,
        columns: PopulationColumns,
        from: Int,
        to: Int,
        strays: Strays,
    ): Boolean {
        val x = population.x
        val y = population.y
        val z = population.z
        val vx = population.vx
        val vy = population.vy
        val vz = population.vz
        val radius = population.radius
        val mass = population.mass
        val toX = columns.x
        val toY = columns.y
        val toZ = columns.z
        val toVx = columns.vx
        val toVy = columns.vy
        val toVz = columns.vz
        val line = lines.state
        val image = lines.image
        val dt = frame.duration
        val t = frame.stepStart
        val most = frame.deviation * frame.deviation
        var bodies = 0.0
        for (k in from until to) {
            val u = vx[k]
            val v = vy[k]
            val w = vz[k]
            val endX = x[k] + u * dt
            val endY = y[k] + v * dt
            val endZ = z[k] + w * dt
            toX[k] = endX
            toY[k] = endY
            toZ[k] = endZ
            toVx[k] = u
            toVy[k] = v
            toVz[k] = w
            val r = radius[k]
            val p = Lines.place(k)
            if (!(r <= line[p + Lines.RADIUS])) isOver = true
            bodies += (r + mass[k]) * 0.0
            val ex = x[k] - (line[p] + line[p + Lines.U] * t)
            val ey = y[k] - (line[p + Lines.Y] + line[p + Lines.V] * t)
            val ez = z[k] - (line[p + Lines.Z] + line[p + Lines.W] * t)
            val fx = ex + (u - line[p + Lines.U]) * dt
            val fy = ey + (v - line[p + Lines.V]) * dt
            val fz = ez + (w - line[p + Lines.W]) * dt
            val isOn = ex * ex + ey * ey + ez * ez <= most && fx * fx + fy * fy + fz * fz <= most
            if (!isOn || image[k] != 0) look(population, k, t, strays)
        }
        return bodies == 0.0 && strays.areFinite
    }

    /** Looks closer at the sphere in slot [k]: it may be at another image than before. */
    private fun look(p: SphereColumns, k: Int, t: Double, strays: Strays) {
        // Whoever is away gets no line, so that nobody is searched for along it.
        if (space.isAway(k) || isOn(p, k, lines.image[k], t)) return
        val code = imageAt(p, k, t)
        if (code != lines.image[k] && isOn(p, k, code, t)) {
            lines.image[k] = code
            if (space.isShared) space.before.image[k] = code
        } else {
            strays.slots.add(k)
            if (!p.isFinite(k, k + 1)) strays.areFinite = false
        }
    }

    /** Whether the sphere in slot [k] follows its line, at the image [code], through the step that starts at [t]. */
    private fun isOn(p: SphereColumns, k: Int, code: Int, t: Double): Boolean =
        lines.isFollowed(k, code, p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k], t, frame.duration)

    /** The image of the line in slot [k] that is nearest to the sphere at time [t]. */
    private fun imageAt(p: SphereColumns, k: Int, t: Double): Int {
        val slow = boxes(p, k, t, 2, 0.0)
        val along = boxes(p, k, t, 0, if (frame.slides) slow * frame.offset(t) else 0.0)
        return frame.code(along, boxes(p, k, t, 1, 0.0), slow)
    }

    private fun boxes(p: SphereColumns, k: Int, t: Double, which: Int, shift: Double): Int {
        if (!frame.isPeriodic[which]) return 0
        val axis = frame.axes[which]
        val boxes = Math.rint((p.position(axis)[k] - shift - lines.at(k, axis, t)) / frame.length[which])
        // A sphere so far away, or nowhere, is on no line.
        return if (boxes >= -FARTHEST && boxes <= FARTHEST) boxes.toInt() else 0
    }

    private companion object {
        /** A new epoch is due when more than one in so many, and some more, have left their lines. */
        const val PART = 8
        const val FEW = 16
        const val FARTHEST = 16.0
    }
}
