package daphnis.analysis.input

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ImageShear
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.format.FormatException
import daphnis.core.format.Snapshot
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import java.nio.file.Path

/**
 * The boundaries of the [states] of a file, each with its own box, where nothing but the file tells. Images slide where
 * [Slide] says.
 */
internal class FileBoxes(private val path: Path, private val states: List<Snapshot>, hasTimes: Boolean) {
    private val slide = Slide.of(path, states, hasTimes)

    /** Discs: nothing in the file is out of the plane z = 0, or moves out of it; of a few spheres that is chance. */
    private val isFlat = states.all { it.isFlat || it.size >= FEWEST_DISCS && it.isInPlane }
    private val reach = Reach(states, isFlat)

    /** What a user should know of how images slide, and of spheres outside; a line each. */
    val notices: List<String> =
        listOfNotNull(if (isFlat) "$path: all z and vz are 0: these are taken for discs, in two dimensions" else null) +
            listOfNotNull(if (slide == null) Slide.doubt(path, states) else slide.words(path)) +
            (0 until if (isFlat) 2 else 3).mapNotNull { reach.beyond(path, it) } + listOfNotNull(reach.beyondLast(path))

    /** In the order of the states. */
    val boundaries: List<BoundaryConditions> = states.map { boundary(it) }

    private fun boundary(state: Snapshot): BoundaryConditions {
        if (state.lengths.all { it.isNaN() } && !isFlat) return Open
        val repeats = BooleanArray(3) { state.repeats(it) }
        val box = reach.box(state)
        if (slide == null) return Periodic(box, repeats[0], repeats[1], repeats[2])
        return Sliding(box, repeats, slide, state.shearOffset, state.time)
    }

    /** A box whose images were displaced by [offset] at the [time] of a state. */
    private class Sliding(
        override val box: Box,
        private val repeats: BooleanArray,
        slide: Slide,
        offset: Double,
        time: Double,
    ) : BoundaryConditions {
        private val flow = MeanFlow(slide.normalAxis, slide.slideAxis, slide.rate)

        override val meanFlow: MeanFlow? = flow.takeIf { slide.isMoving }

        override val shear: ImageShear = ImageShear.at(box, flow, offset, time)

        override fun contactFaces(axis: Int): ContactFaces =
            if (repeats[axis] && axis < space.dimensions) ContactFaces.PERIODIC else ContactFaces.OPEN

        override fun endStep(population: Population, time: Double): Unit =
            throw UnsupportedOperationException("states of a file are measured and do not go on")
    }
}

/**
 * How far the spheres of all [states] reach along axes on which the box does not repeat, so that none of a state is
 * outside the bins of another.
 */
private class Reach(private val states: List<Snapshot>, private val isFlat: Boolean) {
    private val all: List<Box> by lazy { states.map { extent(it.population()) } }
    private val outside = Array(3) { axis -> states.indexOfFirst { outside(it, axis) >= 0 } }

    /** The box of [state]: where the file has no edge, or spheres beyond it, it ends where spheres do. */
    fun box(state: Snapshot): Box {
        val low = DoubleArray(3) { -state.lengths[it] / 2 }
        val high = DoubleArray(3) { state.lengths[it] / 2 }
        for (axis in 0..2) {
            val isOpen = state.lengths[axis].isNaN()
            if (!isOpen && (state.repeats(axis) || outside[axis] < 0)) continue
            low[axis] = minOf(all.minOf { it.lower(axis) }, if (isOpen) Double.MAX_VALUE else low[axis])
            high[axis] = maxOf(all.maxOf { it.upper(axis) }, if (isOpen) -Double.MAX_VALUE else high[axis])
        }
        if (isFlat) return Box.flat(low[0], low[1], high[0], high[1])
        return Box(low[0], low[1], low[2], high[0], high[1], high[2])
    }

    /** One line about a sphere beyond a face along [axis] in the file at [path]; null when there is none. */
    fun beyond(path: Path, axis: Int): String? {
        val frame = outside[axis]
        if (frame < 0) return null
        val state = states[frame]
        val k = outside(state, axis)
        val name = "xyz"[axis]
        return "$path: particle ${state.id[k]} at $name = ${state.position[axis][k] + state.shift[axis]} in frame " +
            "$frame is outside the box, which does not repeat along $name: it is taken to end where spheres do"
    }

    /** One line where all is open and the last state, whose box is taken, is not the widest; null for nothing. */
    fun beyondLast(path: Path): String? {
        if (states.any { state -> state.lengths.any { !it.isNaN() } }) return null
        val last = all.last()
        val wider = all.indexOfFirst { box ->
            (0..2).any { box.lower(it) < last.lower(it) || box.upper(it) > last.upper(it) }
        }
        if (wider < 0) return null
        return "$path: there is no box, and spheres of frame $wider are outside that around the last state: " +
            "profiles and maps end there"
    }

    /** The first particle that is outside along [axis], where nothing repeats; −1 for none. */
    private fun outside(state: Snapshot, axis: Int): Int {
        val half = state.lengths[axis] / 2 * (1 + ROUND_OFF)
        if (half.isNaN() || state.periodic[axis]) return -1
        return state.position[axis].indexOfFirst { Math.abs(it) > half }
    }
}

/** @throws FormatException when the box of one of [states] leans along another axis than that of another */
internal fun leaningState(path: Path, states: List<Snapshot>): Snapshot? {
    var first = -1
    for ((k, state) in states.withIndex()) {
        if (!state.leans()) continue
        if (first < 0) first = k
        val other = states[first]
        if (other.normalAxis == state.normalAxis && other.slideAxis == state.slideAxis) continue
        throw FormatException(
            "$path: the box leans ${other.way()} in frame $first and ${state.way()} in frame $k; " +
                "images can slide one way only",
        )
    }
    return states.getOrNull(first)
}

/** Whether an image is displaced by other than whole boxes, and repeats. */
private fun Snapshot.leans(): Boolean {
    val length = lengths[slideAxis]
    val rest = shearOffset - Math.rint(shearOffset / length) * length
    return Math.abs(rest) > ROUND_OFF * length && periodic[normalAxis] && !lengths[normalAxis].isNaN()
}

/** Whether the box repeats along [axis], with an edge that is known. */
internal fun Snapshot.repeats(axis: Int) = periodic[axis] && !lengths[axis].isNaN()

private fun Snapshot.way() = "along ${"xyz"[slideAxis]} across ${"xyz"[normalAxis]}"

private const val FEWEST_DISCS = 4
private const val ROUND_OFF = 1e-9
