package daphnis.analysis.movie

import daphnis.analysis.insitu.State
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.table.UnitNames
import daphnis.core.boundary.ContactFaces
import kotlin.math.ceil
import kotlin.math.sqrt

/**
 * Looks at some states of a movie and decides what all frames have in common: what is in view, what the colours stand
 * for, how bright a surface density is. Ranges leave out the outermost parts in a thousand, so that a sphere which is
 * shot away does not make all others small and dark. First [look] at the samples, then [weigh] each, then [scene].
 */
internal class Survey(private val options: MovieOptions) {
    private var sight: Sight? = null
    private var window: Window? = null
    private var colours: ColourRange? = null

    /** Names of the materials of particles, by number. */
    private val materials = sortedMapOf<Int, String>()
    private var typicalRadius = 0.0
    private var meanRadius = 0.0
    private var number = 0
    private var densest = 0.0
    private val view by lazy { Viewport(window!!, options.width) }
    private val isImage by lazy { !Scene.isDisc(view, typicalRadius) }
    private val grid by lazy { SurfaceGrid(view, cell) }

    /** Cells of an image are pixels; those that colour discs hold some of them each. */
    private val cell by lazy { if (isImage) 1 else ceil(sqrt(DISCS_PER_CELL / perPixel())).toInt().coerceAtLeast(1) }
    private val passes by lazy { if (isImage && perPixel() > 1) 1 else 2 }

    private fun perPixel() = number / (view.height.toDouble() * (view.endColumn - view.firstColumn))

    fun look(state: State) {
        val of = (0 until state.population.size).filter(state::isParticle)
        val radius = state.population.radius
        number = maxOf(number, of.size)
        if (sight == null) sight = Sight.of(options.view, state.boundary.box)
        val seen = windowOf(state, thinned(of))
        window = window?.union(seen) ?: seen
        if (of.isEmpty()) return
        if (typicalRadius == 0.0) {
            typicalRadius = quantile(DoubleArray(of.size) { radius[of[it]] }, 0.5)
            meanRadius = of.sumOf { radius[it] } / of.size
        }
        val isRare = options.colour == MovieColour.SIZE || options.colour == MovieColour.MATERIAL
        val range = rangeOf(state, if (isRare) of else thinned(of)) ?: return
        if (options.colour == MovieColour.MATERIAL) name(state, of)
        colours = colours?.union(range) ?: range
    }

    private fun rangeOf(state: State, of: List<Int>): ColourRange? {
        val values = DoubleArray(of.size) { state.quantity(options.colour, of[it]) }
        return when (options.colour) {
            MovieColour.SPEED, MovieColour.SPIN -> ColourRange(0.0, quantile(values, 1 - RARE))
            MovieColour.SIZE -> ColourRange(values.min(), values.max(), mayBeLogarithmic = true)
            MovieColour.HEIGHT -> ColourRange(quantile(values, RARE), quantile(values, 1 - RARE))
            MovieColour.MATERIAL -> ColourRange(values.min(), values.max())
            MovieColour.DENSITY -> null
        }
    }

    /** Bodies are drawn in a colour of their own, so what only they are made of is not named. */
    private fun name(state: State, of: List<Int>) {
        val p = state.population
        if (!p.hasMaterials) return
        for (number in of.mapTo(HashSet()) { p.material[it].toInt() }) materials[number] = p.materials[number]
    }

    /** About [MOST] of the indices [of], evenly. */
    private fun thinned(of: List<Int>): List<Int> {
        val stride = of.size / MOST + 1
        return of.indices.step(stride).map { of[it] }
    }

    private fun windowOf(state: State, of: List<Int>): Window {
        val (left, right) = extent(state, sight!!.across, of)
        val (bottom, top) = extent(state, sight!!.up, of)
        return Window(left, right, bottom, top)
    }

    /** The box, or where its faces are open the spheres, of a room within walls both. Bodies are always in view. */
    private fun extent(state: State, axis: Int, of: List<Int>): Pair<Double, Double> {
        val p = state.population
        val box = state.boundary.box
        if (state.boundary.contactFaces(axis) != ContactFaces.OPEN) return box.lower(axis) to box.upper(axis)
        val margin = of.maxOfOrNull { p.radius[it] } ?: 0.0
        val values = DoubleArray(of.size) { p.position(axis)[of[it]] }
        var low = quantile(values, RARE) - margin
        var high = quantile(values, 1 - RARE) + margin
        for (k in 0 until p.size) {
            if (state.isParticle(k)) continue
            low = minOf(if (low.isNaN()) p.position(axis)[k] else low, p.position(axis)[k] - p.radius[k])
            high = maxOf(if (high.isNaN()) p.position(axis)[k] else high, p.position(axis)[k] + p.radius[k])
        }
        if (state.boundary.walls.surfaces.isNotEmpty()) {
            low = if (low.isNaN()) box.lower(axis) else minOf(low, box.lower(axis))
            high = if (high.isNaN()) box.upper(axis) else maxOf(high, box.upper(axis))
        }
        return if (low < high) low to high else -1.0 to 1.0
    }

    fun weigh(state: State) {
        grid.clear()
        val p = state.population
        for (k in 0 until p.size) {
            if (!state.isParticle(k) || isImage && Scene.isDisc(view, p.radius[k])) continue
            val x = p.position(sight!!.across)[k]
            val y = p.position(sight!!.up)[k]
            if (x !in view.window.left..view.window.right || y !in view.window.bottom..view.window.top) continue
            grid.add(view.x(x), view.y(y), p.mass[k], 0.0)
        }
        grid.smooth(passes)
        val densities = grid.densities()
        if (densities.isNotEmpty()) densest = maxOf(densest, quantile(densities, 1 - RARE))
    }

    fun scene(units: UnitNames, omega: Double?): Scene {
        val range = if (options.colour == MovieColour.DENSITY) ColourRange(0.0, densest) else colours
        val scale = PlotScale(units, omega, if (meanRadius > 0) meanRadius else 1.0)
        val shown = range ?: ColourRange(0.0, 0.0)
        return Scene(options, view, sight!!, isImage, cell, passes, shown, densest, scale, materials)
    }

    private companion object {
        const val RARE = 1e-3
        const val MOST = 50_000
        const val DISCS_PER_CELL = 6.0
    }
}
