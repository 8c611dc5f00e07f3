package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Images
import daphnis.core.parallel.Extremes
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population

/**
 * The layouts of a [Grid], one for each class of sizes, smallest first; their cells and rows are numbered one after the
 * other.
 */
internal class GridLevels {
    private val classes = SizeClasses()
    private val layouts = ArrayList<GridLayout>()
    private val extremes = Extremes()
    private val from = DoubleArray(3)
    private val size = DoubleArray(3)

    /** Number of levels. */
    val count: Int get() = classes.count
    var cellCount = 0
        private set
    var rowCount = 0
        private set

    operator fun get(level: Int): GridLayout = layouts[level]

    /** The level whose cells hold spheres of [radius]. */
    fun of(radius: Double): Int = classes.of(radius)

    fun prepare(
        population: Population,
        boundary: BoundaryConditions,
        images: Images,
        duration: Double,
        reach: DoubleArray,
        structure: SearchStructure,
        loop: RangeLoop,
    ) {
        for (axis in 0..2) measure(axis, population, boundary, loop)
        extremes.measure(population.radius, population.size, loop)
        val largest = extremes.magnitude
        for (axis in 0..2) Scales.requireLengths(axis, from[axis], from[axis] + size[axis], largest)
        classes.divide(population, extremes.least, largest, structure, reach, size)
        cellCount = 0
        rowCount = 0
        for (level in 0 until count) {
            if (level == layouts.size) layouts += GridLayout()
            val layout = layouts[level]
            layout.prepare(
                classes.spheres[level],
                classes.largest[level],
                boundary,
                images,
                duration,
                reach,
                from,
                size,
            )
            layout.firstCell = cellCount
            layout.firstRow = rowCount
            cellCount += layout.cellCount
            rowCount += layout.rowCount
        }
    }

    private fun measure(axis: Int, population: Population, boundary: BoundaryConditions, loop: RangeLoop) {
        if (boundary.hasImages(axis)) {
            from[axis] = boundary.box.lower(axis)
            size[axis] = boundary.box.length(axis)
            return
        }
        extremes.measure(population.position(axis), population.size, loop)
        from[axis] = if (population.size == 0) 0.0 else extremes.least
        size[axis] = if (population.size == 0) 0.0 else extremes.greatest - extremes.least
    }

    /** The level of row [row]. */
    fun ofRow(row: Int): Int {
        var level = 0
        while (level < count - 1 && row >= layouts[level + 1].firstRow) level++
        return level
    }

    /** About how many spheres are in the cells that are searched for one of them, if they are spread evenly. */
    fun candidates(): Double {
        var sum = 0.0
        for (level in 0 until count) sum += layouts[level].candidates()
        return sum
    }
}
