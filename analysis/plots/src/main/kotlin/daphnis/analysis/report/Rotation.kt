package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State
import daphnis.analysis.profile.RotationByGroup
import daphnis.analysis.statistics.BlockAverage
import daphnis.core.population.VelocityMoments
import daphnis.core.run.SeriesColumns

/**
 * How the particles spin on average: from the rows of series.csv from the time [from] on, else, and where there are
 * bodies, which these rows have in their sums, from the states.
 */
internal class Rotation(input: AnalysisInput, private val from: Double, last: State) {
    /** Moment of inertia over mass · radius²; that of solid spheres or discs where no scenario says otherwise. */
    val momentFactor: Double = input.scenario?.momentFactor ?: last.boundary.space.momentFactor
    private val states = Averages(Measure(::ofState))
    private val hasBodies = (0 until last.population.size).any { !last.isParticle(it) }
    private val series = input.series?.takeIf { SeriesColumns.ROTATIONAL_TEMPERATURE in it && !hasBodies }
    private val rows = series?.let { s -> s[SeriesColumns.TIME].indices.filter { s[SeriesColumns.TIME][it] >= from } }
        ?.takeIf { it.size >= 2 }

    /** Takes in one more state. */
    fun add(state: State) = states.add(state)

    /** Σ I ω²/3M, the mean spin in it, (length/time)². */
    val temperature: BlockAverage get() = average(TEMPERATURE)

    /** Mean over time of what that is over the granular temperature at each time. */
    val ratio: BlockAverage get() = average(RATIO)

    /** Mean spin along [axis] by number. */
    fun mean(axis: Int): BlockAverage = average(SPIN + axis)

    private fun average(k: Int): BlockAverage {
        if (rows == null) return states.average(k)
        val table = series!!
        return BlockAverage.of(
            DoubleArray(rows.size) {
                val row = rows[it]
                val rotational = table[SeriesColumns.ROTATIONAL_TEMPERATURE][row]
                when (k) {
                    TEMPERATURE -> rotational
                    RATIO -> over(rotational, table[SeriesColumns.GRANULAR_TEMPERATURE][row])
                    else -> table[SeriesColumns.MEAN_SPIN[k - SPIN]][row]
                }
            },
        )
    }

    private fun ofState(state: State): DoubleArray {
        val all = RotationByGroup(SphereGroups.ALL, momentFactor).of(state)
        fun number(column: String) = all[RotationByGroup.COLUMNS.indexOf(column)]
        val moments = VelocityMoments.within(state.boundary, state.population, state.frequencies, state.firstBody)
        val temperature = number("temperature") / number("mean_mass")
        val spins = listOf("mean_wx", "mean_wy", "mean_wz").map(::number)
        return doubleArrayOf(temperature, over(temperature, moments.temperature)) + spins
    }

    /** NaN where spheres are at rest, and their temperature is rounding. */
    private fun over(rotational: Double, translational: Double): Double =
        if (translational > LOST * rotational) rotational / translational else Double.NaN

    private companion object {
        const val TEMPERATURE = 0
        const val RATIO = 1
        const val SPIN = 2

        /** Rounding of speeds, squared, with room to spare. */
        const val LOST = 1e-24
    }
}
