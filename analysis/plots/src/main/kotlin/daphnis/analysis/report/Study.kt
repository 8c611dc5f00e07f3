package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Figure
import daphnis.analysis.plot.PictureFiles
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.table.UnitNames
import daphnis.analysis.theory.HardDiscs
import daphnis.analysis.theory.HardSpheres
import daphnis.core.format.Snapshot
import daphnis.core.scenario.Scenario
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI

/**
 * What the sections of a report are made from.
 *
 * @property from averages begin at this time
 * @property isStartFound whether that is because the run drifted before, see [SteadyStart]
 * @property isGrowing whether spheres grow, so that no part of the run is steady
 * @property averaged indices of the states that are averaged, ascending; never empty
 */
internal class Study(
    val input: AnalysisInput,
    val from: Double,
    val averaged: List<Int>,
    val options: AnalysisOptions,
    directory: Path,
    val isStartFound: Boolean = false,
    val isGrowing: Boolean = Growth.isSeen(input),
) {
    val lastSnapshot: Snapshot = input.snapshot(input.size - 1)
    val last: State = input.state(input.size - 1, lastSnapshot)
    val bulk: Bulk = Bulk(last, input)
    val boxes: Boxes = Boxes(averaged.map { input.boundary(it) })
    val motion: Motion = Motion(input, from, last)

    val judgement: Judgement = Judgement(
        from,
        averaged.size,
        isGrowing,
        PerturbedSheet.isOfFewPhases(input, last, averaged),
        RunHistory.ofRows(input, motion),
    ) {
        RunHistory.of(input, from).ifEmpty { listOfNotNull(motion.history(from)) }
    }

    /** The waves of a ring that wrote modes often enough; null for others. */
    val waves: Waves? = Waves.of(input, from)
    val plots: Path = directory.resolve("plots")
    val pictures: PictureFiles = PictureFiles(plots)
    val tables: Path = directory.resolve("tables")
    val units: UnitNames = input.units
    val scale: PlotScale = PlotScale(units, input.omega, bulk.meanRadius)
    val isRing: Boolean = input.omega != null

    /**
     * The scenario, where it decides the physics; null without one, for the run of a program, whose law and forces may
     * be others, and where spheres come or leave, so that there is no one density.
     */
    val physics: Scenario? = input.scenario?.takeUnless {
        it.sources.isNotEmpty() || input.directory?.program?.let { p -> Files.exists(p) } == true
    }

    /** Whether walls that are no faces of the box cut off parts of it: densities over the box then tell nothing. */
    val isRoomCut: Boolean = last.boundary.walls.surfaces.isNotEmpty()

    /** Whether spheres or discs fill the room so densely that they may be a crystal. */
    val mayFreeze: Boolean = !isRoomCut &&
        bulk.fillingFactor >= if (last.boundary.space.isPlane) HardDiscs.FREEZING else HardSpheres.FREEZING

    /** Whether light through it means something: it ends above and below, and is a ring or may be one. */
    val isLit: Boolean = !last.boundary.repeats(2) &&
        !last.boundary.space.isPlane &&
        !isRoomCut &&
        (isRing || input.scenario == null)

    /** Why light through it means nothing; null where it does. */
    val unlit: String?
        get() = when {
            isLit -> tooFew()
            last.boundary.space.isPlane -> "discs in a plane have no height"
            isRoomCut -> ROOM_CUT
            last.boundary.repeats(2) -> "the box is filled above and below"
            else -> "there is no ring: the scenario has no frame"
        }

    /** What is simulated: a patch of a ring, or a box. */
    val place: String = if (isRing) "patch" else "box"

    /** What collides. */
    val bodies: String = if (last.boundary.space.isPlane) "discs" else "spheres"

    /** Whether pairs and maps are worth looking at: not for patches far longer than wide. */
    val isCompact: Boolean =
        boxes.mean.let { maxOf(it.length(0), it.length(1)) <= LONGEST * minOf(it.length(0), it.length(1)) }

    /** Whether what happens varies along x alone: patches that are much longer across their mean flow than along it. */
    val isThin: Boolean = !isCompact &&
        boxes.mean.length(0) > boxes.mean.length(1) &&
        (last.boundary.meanFlow?.normalAxis ?: 0) == 0

    /** Which states an average is over: `5 states of 12, time 3.75 to 10 s (1.2 to 3.1 orbits)`. */
    val averagedStates: String = run {
        val all = if (averaged.size < input.size) " of ${input.size}" else ""
        val span = span(input.times[averaged.first()], input.times[averaged.last()])
        "${ReportText.count(averaged.size, "state")}$all, time $span"
    }

    val overAverages: String = "Averages over $averagedStates."
    val overLast: String = "The last state, time ${time(last.time)}."

    /** What [motion] is over. */
    val overMotion: String = if (motion.transport != null) {
        "Averages over the rows of transport.csv from time ${time(from)} on, and over $averagedStates."
    } else {
        overAverages
    }

    /** [time] with its unit, in Hill's frame also in orbits. */
    fun time(time: Double): String = span(time, time)

    private fun span(begin: Double, end: Double): String {
        fun text(factor: Double) = ReportText.span(begin * factor, end * factor)
        val inUnits = UnitNames.amount(text(1.0), units.time)
        val omega = input.omega ?: return inUnits
        val orbits = text(omega / (2 * PI))
        return "$inUnits ($orbits ${if (orbits == "1") "orbit" else "orbits"})"
    }

    /** Why nothing is said of fewer than [least] particles; null when there are enough. */
    fun tooFew(least: Int = FEWEST): String? {
        val particles = bulk.particles
        if (particles >= least) return null
        val there = if (particles == 1) "there is" else "there are"
        return "$there ${ReportText.count(particles, "particle")}; it takes $least at least"
    }

    /** A quantity with the unit of length at an axis. */
    fun lengthAxis(quantity: String): String = UnitNames.axis(quantity, units.length)

    /** Draws [figure] into `plots/NAME.svg` and `.png` and onto [page]. */
    fun draw(page: ReportPage, figure: Figure, name: String, alt: String, caption: String, height: Int = Chart.HEIGHT) {
        page.svg(pictures.write(figure, name, Chart.WIDTH, height), alt, caption)
    }

    companion object {
        /** Why what is measured over the box is left out where [isRoomCut]. */
        const val ROOM_CUT = "walls cut off a part of the box"

        /** Particles below which averages over them mean nothing. */
        private const val FEWEST = 10

        /** Length of a patch over its width up to which it is compact. */
        private const val LONGEST = 20
    }
}
