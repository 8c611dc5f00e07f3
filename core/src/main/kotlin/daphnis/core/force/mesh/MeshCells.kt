package daphnis.core.force.mesh

import daphnis.core.population.SphereColumns
import kotlin.math.floor

/**
 * Spheres in the order of the cells of a mesh, column by column along x, row by row along y, and by id within a cell:
 * the same order whatever that of the population. Positions along x and y are from the lower corner of the box.
 */
internal class MeshCells {
    /** Index among the spheres by place. */
    var order = IntArray(0)
        private set
    var x = DoubleArray(0)
        private set
    var y = DoubleArray(0)
        private set
    var z = DoubleArray(0)
        private set
    var mass = DoubleArray(0)
        private set

    /** The place of the first sphere of a cell, by column · rows + row; one more at the end. */
    var start = IntArray(0)
        private set
    private var cell = IntArray(0)
    private var px = 0.0
    private var py = 0.0

    /** How far along y the image at +L_x is displaced. */
    var offset = 0.0
        private set

    /** How many spheres there are. */
    var count = 0
        private set

    fun sort(p: SphereColumns, points: MeshPoints, lowerX: Double, lowerY: Double, offset: Double) {
        this.offset = offset
        count = p.size
        makeRoom(p.size, points.nx * points.ny)
        start.fill(0)
        for (k in 0 until p.size) {
            locate(p, k, points, lowerX, lowerY)
            val c = column(px, points) * points.ny + row(py, points)
            cell[k] = c
            start[c]++
        }
        // The end of each cell, which placing its spheres from there turns into its start.
        for (c in 1 until start.size) start[c] += start[c - 1]
        for (k in p.size - 1 downTo 0) order[--start[cell[k]]] = k
        finish(p, points, lowerX, lowerY)
    }

    /** Sets [px] and [py] to where the sphere at index [k], or an image of it, is in the box. */
    private fun locate(p: SphereColumns, k: Int, points: MeshPoints, lowerX: Double, lowerY: Double) {
        px = p.x[k] - lowerX
        val around = floor(px / points.lx)
        px -= around * points.lx
        py = p.y[k] - lowerY - around * offset
        py -= floor(py / points.ly) * points.ly
    }

    private fun makeRoom(spheres: Int, cells: Int) {
        if (start.size != cells + 1) start = IntArray(cells + 1)
        if (mass.size >= spheres) return
        order = IntArray(spheres)
        cell = IntArray(spheres)
        x = DoubleArray(spheres)
        y = DoubleArray(spheres)
        z = DoubleArray(spheres)
        mass = DoubleArray(spheres)
    }

    private fun finish(p: SphereColumns, points: MeshPoints, lowerX: Double, lowerY: Double) {
        for (k in 1 until p.size) {
            var place = k
            while (place > 0 &&
                cell[order[place - 1]] == cell[order[place]] &&
                p.id[order[place - 1]] > p.id[order[place]]
            ) {
                order[place] = order[place - 1].also { order[place - 1] = order[place] }
                place--
            }
        }
        for (place in 0 until p.size) {
            val k = order[place]
            locate(p, k, points, lowerX, lowerY)
            x[place] = px
            y[place] = py
            z[place] = p.z[k]
            mass[place] = p.mass[k]
        }
    }

    companion object {
        fun column(x: Double, points: MeshPoints): Int = clamp(x * points.perX, points.nx)

        fun row(y: Double, points: MeshPoints): Int = clamp(y * points.perY, points.ny)

        private fun clamp(place: Double, count: Int): Int = minOf(maxOf(place.toInt(), 0), count - 1)
    }
}
