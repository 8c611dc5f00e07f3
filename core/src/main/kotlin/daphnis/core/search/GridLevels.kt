package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.parallel.Extremes
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns
import daphnis.core.space.Images

/**
 * The layouts of a [Grid], one for each class of sizes, smallest first; their cells and rows are numbered one after the
 * other.
 */
internal class GridLevels {
    private val classes = SizeClasses()
    private val layouts = ArrayList<GridLayout>()
    private val extremes = Extremes()
    private val extent = GridExtent()

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
        population: SphereColumns,
        boundary: BoundaryConditions,
        images: Images,
        duration: Double,
        reach: DoubleArray,
        structure: SearchStructure,
        loop: RangeLoop,
        middle: DoubleArray,
    ) {
        extent.measure(population, boundary, middle, loop)
        extremes.measure(population.radius, population.size, loop)
        val largest = extremes.magnitude
        extent.requireComputable(largest)
        classes.divide(population, extremes.least, largest, structure, reach, extent.span)
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
                extent,
            )
            layout.firstCell = cellCount
            layout.firstRow = rowCount
            cellCount += layout.cellCount
            rowCount += layout.rowCount
        }
    }

    /** The level of row [row]. */
    fun ofRow(row: Int): Int {
        var level = 0
        while (level < count - 1 && row >= layouts[level + 1].firstRow) level++
        return level
    }

    /** See [GridLayout.haveFlow]. */
    val haveFlow: Boolean get() = (0 until count).any { layouts[it].haveFlow }

    /** About how many spheres are in the cells that are searched for one of them, if they are spread evenly. */
    fun candidates(): Double {
        var sum = 0.0
        for (level in 0 until count) sum += layouts[level].candidates()
        return sum
    }
}
