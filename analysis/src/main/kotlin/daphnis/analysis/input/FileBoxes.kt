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

    /** What a user should know of how images slide; null for nothing. */
    val notice: String? get() = if (slide == null) Slide.doubt(path, states) else slide.words(path)

    /** In the order of the states. */
    val boundaries: List<BoundaryConditions> = states.map { boundary(it) }

    private fun boundary(state: Snapshot): BoundaryConditions {
        if (state.lengths.all { it.isNaN() }) return Open
        val repeats = BooleanArray(3) { state.periodic[it] && !state.lengths[it].isNaN() }
        val box = box(state.lengths, states.last().population())
        if (slide == null) return Periodic(box, repeats[0], repeats[1], repeats[2])
        return Sliding(box, repeats, slide, state.shearOffset, state.time)
    }

    /** Where the file says no edge, the box ends where the spheres of the last state do. */
    private fun box(lengths: DoubleArray, last: Population): Box {
        val ends = extent(last)
        fun lower(axis: Int) = if (lengths[axis].isNaN()) ends.lower(axis) else -lengths[axis] / 2
        fun upper(axis: Int) = if (lengths[axis].isNaN()) ends.upper(axis) else lengths[axis] / 2
        return Box(lower(0), lower(1), lower(2), upper(0), upper(1), upper(2))
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
            if (repeats[axis]) ContactFaces.PERIODIC else ContactFaces.OPEN

        override fun endStep(population: Population, time: Double): Unit =
            throw UnsupportedOperationException("states of a file are measured and do not go on")
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

private fun Snapshot.way() = "along ${"xyz"[slideAxis]} across ${"xyz"[normalAxis]}"

private const val ROUND_OFF = 1e-9
