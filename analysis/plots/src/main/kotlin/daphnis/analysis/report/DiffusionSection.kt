package daphnis.analysis.report

import daphnis.analysis.diffusion.Coordinate
import daphnis.analysis.diffusion.Diffusion
import daphnis.analysis.diffusion.FiniteCube
import daphnis.analysis.diffusion.MeanSquareDisplacement
import daphnis.analysis.diffusion.Trajectories
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.analysis.theory.EnskogGas
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.format.Snapshot
import kotlin.math.PI

/** Self-diffusion, from the states from a time on. */
internal class DiffusionSection(private val study: Study) : Section {
    private val input = study.input
    private val units = study.units
    private val omega = input.omega
    private val haveSwaps = study.physics?.swaps != null
    private val meanRadius = study.bulk.meanRadius
    private val chosen = chosen(study.from)
    private val last = study.lastSnapshot

    /** The key of a scenario that makes more states. */
    private val ofRuns = if (input.directory == null) "" else " (output.snapshotEvery)"
    private val coordinates = coordinates(last, study.last.boundary)
    private var trajectories = if (isExpected() && last.image != null) begun() else null
    private val displacement by lazy { trajectories?.let { MeanSquareDisplacement(it) } }

    override val heading = "Diffusion"
    override val over get() = "Mean square displacements over all origins, without images " +
        "and relative to the centre of mass. " +
        (if (omega == null && coordinates.size > 1) "D is the mean of those along the axes. " else "") +
        (if (haveSwaps) SWAPPED else "") +
        "${ReportText.count(chosen.size, "state")} from time ${study.time(study.from)} on." +
        study.judgement.bars(" $ASSUMED").takeIf { it == " $ASSUMED" }.orEmpty()
    override val leftOut get() = when {
        PerturbedSheet.isSeen(study.last) -> "in a perturbed sheet images come nearer and move away"
        study.isGrowing -> "spheres grow, so no time of the run is like another"
        SourcesSection.areThere(
            study,
        ) -> "spheres come or leave, so those that stay are no sample, and ids are given again"
        (0..2).none { last.periodic[it] } -> "no axis is periodic"
        coordinates.isEmpty() -> "no periodic axis is without a mean flow"
        chosen.size < MeanSquareDisplacement.FEWEST_TIMES ->
            "there ${if (chosen.size == 1) "is" else "are"} ${ReportText.count(chosen.size, "state")} from time " +
                "${study.time(study.from)} on; it takes ${MeanSquareDisplacement.FEWEST_TIMES}$ofRuns"
        !input.hasTimes -> "the file has no times; give the time of a step"
        omega != null && !input.hasVelocities -> "guiding centres follow from velocities"
        last.image == null -> "the states do not say how often particles crossed the box"
        displacement == null -> "too few particles"
        else -> null
    }
    private val velocities =
        VelocityPart(
            study,
            if (trajectories == null ||
                !areFollowed()
            ) {
                emptyList()
            } else {
                axes(last, study.last.boundary)
            },
        )
    private val places = if (trajectories == null) emptySet() else chosen.toSet()
    private val moving = velocities.followed.toSet()
    override val followed = (places + moving).sorted()
    private var seen = 0

    override fun follow(snapshot: Snapshot) {
        val k = followed[seen++]
        if (k in moving) velocities.follow(snapshot)
        if (k !in places) return
        if (snapshot.image == null) trajectories = null
        trajectories?.add(snapshot)
    }

    /** Whether velocities stay with the ids of particles, and turn about nothing. */
    private fun areFollowed() = omega == null && !haveSwaps

    private fun isExpected() = !PerturbedSheet.isSeen(study.last) &&
        !SourcesSection.areThere(study) &&
        chosen.size >= MeanSquareDisplacement.FEWEST_TIMES &&
        coordinates.isNotEmpty() &&
        input.hasTimes &&
        (omega == null || input.hasVelocities)

    /** D along each coordinate that counts, and their mean. */
    override fun numbers(): List<NumberRow> {
        val d = displacement ?: return emptyList()
        if (omega != null) {
            return listOfNotNull(
                row(
                    "guiding_centre_diffusion",
                    "self-diffusion of guiding centres D_X",
                    ofGuidingCentres(d),
                    "r² Ω",
                    meanRadius * meanRadius * omega,
                ),
            )
        }
        val all = coordinates.indices.toList().toIntArray()
        val mean = d.diffusion(*all) ?: return velocities.numbers(null)
        val along = all.map {
            val axis = coordinates[it].name
            row(
                "self_diffusion_$axis",
                "self-diffusion D_$axis",
                d.diffusion(it, from = mean.from),
                units.viscosity,
                1.0,
            )
        }
        val whole = if (all.size == 1) null else row("self_diffusion", "self-diffusion D", mean, units.viscosity, 1.0)
        return (listOf(whole, infinite(mean)) + along).filterNotNull() + velocities.numbers(mean)
    }

    /** What an epicycle does within an orbit is no diffusion. */
    private fun ofGuidingCentres(d: MeanSquareDisplacement) = d.diffusion(0, least = 2 * PI / omega!!)

    /** D without the images of a periodic cube; null where that is not known. */
    private fun infinite(mean: Diffusion): NumberRow? {
        val diameter = 2 * meanRadius
        val scenario = study.physics?.takeIf { input.hasVelocities } ?: return null
        if (!ElasticGas.isCube(scenario, study.last) || study.bulk.fillingFactor > EnskogGas.MOST_FILLED) return null
        val mass = study.last.population.mass[0]
        val thermal = mass * study.motion.temperature.mean
        val viscosity = EnskogGas.viscosity(diameter, mass, study.bulk.fillingFactor, thermal)
        val edge = study.last.boundary.box.length(0)
        val density = study.last.population.size * mass / (edge * edge * edge)
        val more = FiniteCube.correction(thermal, viscosity, density, mean.value, edge)
        val note = "D + 2.837297 kT/(6π (η + ρD) L), after Yeh & Hummer 2004; η is Enskog's, " +
            ReportText.short(viscosity)
        val d = Diffusion(mean.value + more, mean.error, mean.from, mean.to)
        return row("self_diffusion_infinite_box", "self-diffusion D∞ of an infinite box", d, units.viscosity, 1.0, note)
    }

    private fun row(
        key: String,
        what: String,
        d: Diffusion?,
        unit: String,
        scale: Double,
        note: String? = null,
    ): NumberRow? {
        if (d == null) return null
        val orbit = if (omega != null) 2 * PI / omega else 1.0
        val time = study.scale.timeName
        val grows = if (study.last.boundary.space.isPlane && omega == null) OF_DISCS else ""
        val lags =
            "slope over lags from ${ReportText.short(d.from / orbit)} to ${ReportText.short(d.to / orbit)} $time$grows"
        val unknown = if (d.error.isNaN()) Unknown.SHORT_TIME else null
        return NumberRow(what, d.value / scale, d.error / scale, unit, null, note ?: lags, unknown, key)
    }

    override fun write(page: ReportPage) {
        val d = displacement ?: return
        val orbit = if (omega != null) 2 * PI / omega else 1.0
        val time = study.scale.timeName
        val lag = DoubleArray(d.lag.size) { d.lag[it] / orbit }
        val curves = coordinates.mapIndexed { c, coordinate ->
            Curve(coordinate.name, lag, d.mean(c), study.judgement.errors(d.error(c)))
        }
        val label = UnitNames.axis("mean square displacement", units.area)
        val figure = Chart.lines(curves, UnitNames.axis("lag", time), label, logX = true, logY = true)
        val bars = study.judgement.bars("Bars are one standard error.")
        val caption = "Mean square displacements. ${caption(d)} $bars"
        study.draw(page, figure, "mean-square-displacement", "mean square displacements", caption)
        val unit = units.area
        val columns = curves.flatMap {
            listOf(Column("msd_${it.name}", unit, it.y), Column("msd_${it.name}_error", unit, it.error!!))
        }
        Table("mean-square-displacement", listOf(Column("lag", time, lag)) + columns).write(study.tables)
        if (omega == null) velocities.write(page, d.diffusion(*coordinates.indices.toList().toIntArray()))
    }

    private fun caption(d: MeanSquareDisplacement): String {
        val found =
            if (omega != null) ofGuidingCentres(d) else d.diffusion(*coordinates.indices.toList().toIntArray())
        val said = if (found == null && omega != null && d.lag.last() < 4 * PI / omega) {
            "A coefficient takes lags of two orbits."
        } else if (found == null) {
            "They do not become linear in time within these lags: no coefficient."
        } else {
            "D is half the slope where they are linear."
        }
        if (omega == null) return said
        return "X is the guiding centre; x swings about it once an orbit, not seen in states at whole orbits. $said"
    }

    private fun begun(): Trajectories? {
        val there = input.idsThroughout().filter { !input.isBody(it) }
        val every = (there.size + MOST_PARTICLES - 1) / MOST_PARTICLES
        val ids = there.filterIndexed { k, _ -> k % maxOf(1, every) == 0 }.toIntArray()
        return if (ids.size < 2) null else Trajectories(coordinates, ids)
    }

    private fun chosen(from: Double): List<Int> {
        val late = input.times.indices.filter { input.times[it] >= from }
        val every = (late.size + MOST_STATES - 1) / MOST_STATES
        return late.filterIndexed { k, _ -> k % maxOf(1, every) == 0 }
    }

    private fun coordinates(snapshot: Snapshot, boundary: BoundaryConditions): List<Coordinate> = if (omega != null) {
        listOf(Coordinate.GuidingCentre(input.frequencies!!), Coordinate.Position(0))
    } else {
        axes(snapshot, boundary).map { Coordinate.Position(it) }
    }

    /** Of a box, those along which particles may diffuse. */
    private fun axes(snapshot: Snapshot, boundary: BoundaryConditions) =
        (0..2).filter { snapshot.periodic[it] && it != boundary.meanFlow?.flowAxis }

    private companion object {
        /** What the errors rest on. */
        const val ASSUMED =
            "± is from blocks of time of all particles together. So particles may move together; what is taken as " +
                "independent is their motion at times that are further apart than the longest lag of the fit. There " +
                "is no ± where the time is shorter than ${MeanSquareDisplacement.FEWEST_WINDOWS + 1} times that lag."

        const val SWAPPED = "Paths are those of places, whose particles swaps exchange; velocities are not followed. "

        /** Alder & Wainwright 1970, Phys. Rev. A 1, 18. */
        const val OF_DISCS = "; in two dimensions it grows with the logarithm of the lag"

        /** Bounds on memory: 61 MB, and on time: seconds. */
        const val MOST_PARTICLES = 20_000
        const val MOST_STATES = 128
    }
}
