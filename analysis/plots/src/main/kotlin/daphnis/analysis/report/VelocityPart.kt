package daphnis.analysis.report

import daphnis.analysis.diffusion.Coordinate
import daphnis.analysis.diffusion.Diffusion
import daphnis.analysis.diffusion.MeanSquareDisplacement
import daphnis.analysis.diffusion.Trajectories
import daphnis.analysis.diffusion.VelocityAutocorrelation
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.core.format.Snapshot
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.hypot

/**
 * The velocity autocorrelation of a box along [axes], and self-diffusion by its integral: of all states from the time of
 * averages on, since it wants them close together, and of every n-th particle where there are many.
 */
internal class VelocityPart(private val study: Study, private val axes: List<Int>) {
    private val input = study.input
    private val units = study.units

    /** Collisions of a particle in a unit of time, where that is known. */
    private val rate: BlockAverage? = study.motion.transport?.collisionRate
    private val late = input.times.indices.filter { input.times[it] >= study.from }
    private val evenly = evenly()

    /** States that are followed, ascending; empty where they tell nothing. */
    val followed: List<Int> =
        if (axes.isEmpty() || !input.hasVelocities || isSparse() || evenly.size < FEWEST) emptyList() else evenly
    private val velocities = if (followed.isEmpty()) null else begun()

    /** One for each longest lag that was asked for. */
    private var made: Pair<Double, VelocityAutocorrelation>? = null

    /** Evenly spread ones: as long as the time between two is that between the first. */
    private fun evenly(): List<Int> {
        val every = (late.size + MOST_STATES - 1) / MOST_STATES
        val chosen = late.filterIndexed { k, _ -> k % maxOf(1, every) == 0 }
        if (chosen.size < 2) return emptyList()
        val step = input.times[chosen[1]] - input.times[chosen[0]]
        val uneven = (1 until chosen.size).firstOrNull {
            abs(input.times[chosen[it]] - input.times[chosen[it - 1]] - step) > SAME_STEP * step
        }
        return chosen.take(uneven ?: chosen.size)
    }

    /** Whether so many collisions are between two states that nothing of the first velocities is left. */
    private fun isSparse(): Boolean {
        val nu = rate?.mean ?: return false
        return evenly.size >= 2 && nu * step() > MOST_COLLISIONS
    }

    private fun step() = input.times[evenly[1]] - input.times[evenly[0]]

    private fun begun(): Trajectories? {
        val there = input.idsThroughout().filter { !input.isBody(it) }
        val most = MOST_VALUES / followed.size
        val every = maxOf(1, (there.size + most - 1) / most)
        val ids = there.filterIndexed { k, _ -> k % every == 0 }.toIntArray()
        return if (ids.size < 2) null else Trajectories(axes.map { Coordinate.Velocity(it) }, ids)
    }

    fun follow(snapshot: Snapshot) {
        velocities?.add(snapshot)
    }

    /** Over lags that a fit of displacements has used, if any. */
    private fun correlation(fit: Diffusion?): VelocityAutocorrelation? {
        val v = velocities?.takeIf { it.size >= MeanSquareDisplacement.FEWEST_TIMES } ?: return null
        val longest = minOf(fit?.to ?: (FEW_LAGS * step()), MOST_LAGS * step())
        made?.let { if (it.first == longest) return it.second }
        return VelocityAutocorrelation(v, longest).also { made = longest to it }
    }

    /** Rows that stand below those of displacements, whose fit is [fit]. */
    fun numbers(fit: Diffusion?): List<NumberRow> {
        val found = correlation(fit)?.takeIf { it.isFine } ?: return emptyList()
        val diffusion = fit?.let { found.diffusion(it.from, it.to) }?.let {
            val unknown = Unknown.SHORT_TIME.takeIf { _ -> it.error.isNaN() }
            val note = "∫⟨v(0)·v(t)⟩ dt/${axes.size} over the lags of that slope"
            NumberRow(
                "self-diffusion D by Green and Kubo",
                it.value,
                it.error,
                units.viscosity,
                null,
                note,
                unknown,
                GREEN_KUBO,
            )
        }
        return listOfNotNull(diffusion, slope(found))
    }

    private fun slope(found: VelocityAutocorrelation): NumberRow? {
        // Spheres that never meet have none but round-off.
        val s = found.slope()?.takeIf { abs(it.mean) * step() > NO_CHANGE } ?: return null
        val unknown = Unknown.SHORT_TIME.takeIf { !s.isLevelled }
        val name = "slope of the velocity autocorrelation C′(0)/C(0)"
        return NumberRow(name, s.mean, s.error, units.rate, expected(), "", unknown, SLOPE)
    }

    /** −2ν/d, of N spheres whose momentum is 0 N/(N − 1) of it. */
    private fun expected(): Reference? {
        val nu = rate ?: return null
        val scenario = study.physics ?: return null
        if (!ElasticGas.isSeen(scenario, study.last) || !ElasticGas.isSmooth(scenario)) return null
        val n = study.bulk.particles.toDouble()
        val value = -2 * nu.mean / study.last.dimensions * n / (n - 1)
        val ofRate = if (nu.isLevelled) 3 * nu.error / nu.mean else 0.0
        return Reference(value, abs(value) * hypot(ofRate, OF_PARABOLA), "−2ν/d, ν of this run")
    }

    fun write(page: ReportPage, fit: Diffusion?) {
        val found = correlation(fit)
        if (found == null || !found.isFine) {
            why(found)?.let(page::paragraph)
            return
        }
        val unit = study.scale.timeName
        val axis = UnitNames.axis("lag", unit)
        val error = study.judgement.errors(found.normalisedError())
        val c = Curve("C(t)/C(0)", found.lag, found.normalised, error)
        val nu = expected()?.value
        val enskog = nu?.let {
            Curve("Enskog, exp(−2νt/d)", found.lag, DoubleArray(found.lag.size) { k -> exp(it * found.lag[k]) })
        }
        val bars = if (found.normalisedError().none { it > NO_CHANGE }) "" else study.judgement.bars(BARS)
        study.draw(
            page,
            Chart.lines(listOfNotNull(c, enskog), axis, "velocity autocorrelation", logX = true, horizontal = 0.0),
            "velocity-autocorrelation",
            "velocity autocorrelation",
            "Velocity autocorrelation ⟨v(t₀)·v(t₀ + t)⟩ over its value at the lag 0, over ${followed.size} states." +
                "${negative(found)} $bars",
        )
        val integral = Curve("∫C dt", found.lag, found.integral(), study.judgement.errors(found.integralError()))
        val level = fit?.value
        val known = if (level == null) "" else " The dashed line is D by displacements."
        study.draw(
            page,
            Chart.lines(
                listOf(integral),
                axis,
                UnitNames.axis("D(t)", units.viscosity),
                logX = true,
                horizontal = level,
            ),
            "green-kubo",
            "integral of the velocity autocorrelation",
            "Its integral over time and the number of axes, D where it no longer changes.$known $bars",
        )
        val columns = listOf(
            Column("lag", unit, found.lag),
            Column("C", units.temperature, found.correlation),
            Column("C_normalised", "", c.y),
            Column("C_normalised_error", "", error),
            Column("D", units.viscosity, integral.y),
            Column("D_error", units.viscosity, integral.error!!),
        )
        Table("velocity-autocorrelation", columns).write(study.tables)
    }

    /** From where on it is below 0, if it clearly is. */
    private fun negative(found: VelocityAutocorrelation): String {
        val error = found.normalisedError()
        val clear = found.lag.indices.filter { found.normalised[it] < -CLEARLY * error[it] }
        val first = clear.firstOrNull() ?: return ""
        val least = clear.minBy { found.normalised[it] }
        val at = UnitNames.amount(ReportText.short(found.lag[first]), study.scale.timeName)
        return " It is clearly negative from $at on, and least, ${ReportText.short(found.normalised[least])}, at " +
            "${UnitNames.amount(ReportText.short(found.lag[least]), study.scale.timeName)}: particles bounce back " +
            "from their neighbours."
    }

    /** Why there is none; null where nothing else would help. */
    private fun why(found: VelocityAutocorrelation?): String? {
        val isSparse = found != null || isSparse()
        if (axes.isEmpty() || !isSparse || !input.hasVelocities) return null
        val apart = UnitNames.amount(ReportText.short(step()), study.scale.timeName)
        return "No velocity autocorrelation: states are $apart apart, and too much of the velocities is forgotten by " +
            "then. More states would show it" + (if (input.directory == null) "." else " (output.snapshotEvery).")
    }

    private companion object {
        const val SLOPE = "velocity_correlation_slope"
        const val GREEN_KUBO = "self_diffusion_green_kubo"
        const val FEWEST = MeanSquareDisplacement.FEWEST_TIMES

        /** Collisions of a particle between two states beyond which there is no use in following them. */
        const val MOST_COLLISIONS = 1.5
        const val SAME_STEP = 0.005

        /** Bounds on memory, in particles times states, and on time: seconds. */
        const val MOST_VALUES = 2_560_000
        const val MOST_STATES = 2_048
        const val MOST_LAGS = 600
        const val FEW_LAGS = 200

        /** By how much the parabola of the slope may miss, relative. */
        const val OF_PARABOLA = 0.01
        const val CLEARLY = 3

        /** Of the logarithm of C in a step, and of its error: round-off. */
        const val NO_CHANGE = 1e-12
        const val BARS = "Bars are one standard error; at lags too long for the time there are none."
    }
}
