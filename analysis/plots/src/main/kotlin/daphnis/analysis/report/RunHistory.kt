package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.series.SeriesTable
import daphnis.analysis.statistics.Steadiness
import daphnis.analysis.transport.Transport
import daphnis.analysis.transport.TransportTable
import daphnis.core.boundary.isChanging
import daphnis.core.population.MeanFlow
import daphnis.core.run.SeriesColumns
import daphnis.core.run.SeriesColumns.GRANULAR_TEMPERATURE
import daphnis.core.run.TransportColumns
import daphnis.core.run.TransportColumns.moment
import daphnis.core.space.Space
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.sqrt

/**
 * A quantity over the whole of a run.
 *
 * @property times ascending
 * @property keys of the numbers of the report that drift with it
 */
internal class History(
    val name: String,
    val times: DoubleArray,
    val values: DoubleArray,
    val keys: Set<String> = emptySet(),
) {
    /** Index of the first value at [from] or later; the number of values when there is none. */
    fun first(from: Double): Int = times.indexOfFirst { it >= from }.let { if (it < 0) times.size else it }

    /** Whether its values from the time [from] on are known to be one, as of spheres at rest: there is no drift to judge. */
    fun isConstant(from: Double): Boolean {
        val averaged = values.copyOfRange(first(from), values.size)
        if (averaged.size < Steadiness.FEWEST) return false
        return averaged.max() - averaged.min() <= ROUND_OFF * averaged.maxOf { abs(it) }
    }

    /** Whether it has a trend over the time [from] on; a change too small for a word is none. */
    fun steadiness(from: Double): Steadiness {
        val averaged = values.copyOfRange(first(from), values.size)
        val found = Steadiness.of(averaged)
        return if (abs(found.change) <= NEGLIGIBLE * abs(averaged.average())) found.steady() else found
    }

    /**
     * Means over whole periods of length [period], without the last one if it is cut short. The same as before where one
     * has fewer than two values, or too few of them are left from the time [from] on to judge.
     */
    fun overPeriods(period: Double, from: Double): History {
        val groups = times.indices.groupBy { floor((times[it] - times[0]) / period).toLong() }.toSortedMap()
        val whole = groups.values.toList().dropLast(1)
        if (whole.any { it.size < 2 }) return this
        val means = History(
            name,
            DoubleArray(whole.size) { k -> whole[k].sumOf { times[it] } / whole[k].size },
            DoubleArray(whole.size) { k -> whole[k].sumOf { values[it] } / whole[k].size },
            keys,
        )
        return if (means.times.size - means.first(from) < Steadiness.FEWEST) this else means
    }

    /** The time from which it is steady by MSER-5; null where it never is. */
    fun steadyFrom(): Double? = Steadiness.steadyFrom(values).let { if (it < 0) null else times[it] }

    private companion object {
        /** Change, as a part of the average, that is not worth a word. */
        const val NEGLIGIBLE = 1e-3

        /** Spread over the largest value that is none. */
        const val ROUND_OFF = 1e-9
    }
}

/** What a run wrote that tells whether it is steady: rows of transport.csv, else of series.csv. */
internal object RunHistory {
    /**
     * The main quantities of [input]; none for a foreign file, or a run that wrote neither. The series counts where
     * transport.csv has too few rows from the time [from] on. A wave comes back to what it was after its period, so in
     * rings that wrote modes they are means over whole periods of the strongest wave, and in a perturbed sheet over those
     * of the perturbation.
     */
    fun of(input: AnalysisInput, from: Double): List<History> =
        (ofMotion(input, from) + listOfNotNull(rotation(input, from), number(input))).let { all ->
            val period = PerturbedSheet.period(input, input.state(input.size - 1)) ?: Waves.of(input, from)?.wavePeriod
            if (period == null) all else all.map { it.overPeriods(period, from) }
        }

    /** Rotational temperature of a run whose spheres spin, where there are rows enough to judge it. */
    private fun rotation(input: AnalysisInput, from: Double): History? {
        val s = input.series?.takeIf { SeriesColumns.ROTATIONAL_TEMPERATURE in it } ?: return null
        if (s[SeriesColumns.TIME].count { it >= from } < Steadiness.FEWEST) return null
        val values = s[SeriesColumns.ROTATIONAL_TEMPERATURE]
        return History("rotational temperature", s[SeriesColumns.TIME], values, OF_SPINS)
    }

    /** Number of particles of a run in which some come or leave by sources. */
    private fun number(input: AnalysisInput): History? {
        val s = input.series?.takeIf { it.size >= 2 && input.scenario?.sources.orEmpty().isNotEmpty() } ?: return null
        return History("number of particles", s[SeriesColumns.TIME], s[SeriesColumns.PARTICLES], OF_NUMBER)
    }

    private fun ofMotion(input: AnalysisInput, from: Double): List<History> {
        val series = input.series?.let { ofSeries(it) }.orEmpty()
        val transport = input.transport?.takeIf { it.size >= 2 } ?: return series
        val isShort = transport[TransportColumns.TIME].count { it >= from } < Steadiness.FEWEST
        if (isShort && series.isNotEmpty()) return series
        val boundary = input.state(input.size - 1).boundary
        return ofTransport(transport, input.omega != null, boundary.space) +
            listOfNotNull(viscosity(transport, boundary.meanFlow.takeUnless { boundary.isChanging }))
    }

    private fun viscosity(t: TransportTable, flow: MeanFlow?): History? {
        if (flow == null || flow.rate == 0.0) return null
        val times = t[TransportColumns.TIME].copyOfRange(1, t.size)
        return History("viscosity", times, Transport(t, flow.rate, flowAxis = flow.flowAxis).viscosities(), OF_STRESS)
    }

    private fun ofTransport(t: TransportTable, ring: Boolean, space: Space): List<History> {
        val trace = DoubleArray(t.size) { t[moment("xx")][it] + t[moment("yy")][it] + t[moment("zz")][it] }
        val time = t[TransportColumns.TIME]
        val speeds = if (ring) {
            listOf(
                History("velocity dispersion", time, DoubleArray(t.size) { sqrt(trace[it]) }, OF_SPEED),
                History("scale height", time, t[TransportColumns.SCALE_HEIGHT], OF_HEIGHT),
            )
        } else {
            listOf(
                History(
                    "granular temperature",
                    time,
                    DoubleArray(t.size) {
                        trace[it] / space.dimensions
                    },
                    OF_SPEED,
                ),
            )
        }
        return speeds + rate(time, t[TransportColumns.COLLISIONS], t[TransportColumns.PARTICLES])
    }

    private fun ofSeries(s: SeriesTable): List<History> {
        if (s.size < 2) return emptyList()
        val rates = rate(s[SeriesColumns.TIME], s[SeriesColumns.COLLISIONS], s[SeriesColumns.PARTICLES])
        if (GRANULAR_TEMPERATURE !in s) return listOf(rates)
        return listOf(History("granular temperature", s[SeriesColumns.TIME], s[GRANULAR_TEMPERATURE], OF_SPEED), rates)
    }

    /** Collisions per particle and time between rows, at the time of the later one. */
    private fun rate(time: DoubleArray, collisions: DoubleArray, particles: DoubleArray): History {
        val rates = DoubleArray(time.size - 1) {
            val each = if (particles[it] > 0) 2 * (collisions[it + 1] - collisions[it]) / particles[it] else 0.0
            each / (time[it + 1] - time[it])
        }
        return History("collisions per particle", time.copyOfRange(1, time.size), rates, OF_COLLISIONS)
    }

    /** Key of the temperature of a box. */
    const val TEMPERATURE = "granular_temperature"

    /** Whether the number of this [key] rises and falls with the temperature of its box: it is no ratio of such. */
    fun followsTemperature(key: String?): Boolean = key in FOLLOWING || key?.startsWith("partial_temperature") == true

    /** Keys of the numbers of a ring that [motion] has from rows of transport.csv or series.csv, and not from states. */
    fun ofRows(input: AnalysisInput, motion: Motion): Set<String> {
        val spins = OF_SPINS.takeIf { input.series?.let { SeriesColumns.ROTATIONAL_TEMPERATURE in it } == true }
        return (if (motion.transport == null) emptySet() else OF_ROWS) + spins.orEmpty()
    }

    private val OF_SPEED = setOf(
        "velocity_dispersion",
        "sigma_x",
        "sigma_y",
        "sigma_z",
        "ellipsoid_orientation",
        TEMPERATURE,
        "reduced_temperature",
        "mean_impact_speed",
        "toomre_q",
        "wall_work_over_dissipation",
    )
    private val OF_NUMBER = setOf("particles", "particle_fluctuations", "filling_factor", "area_fraction")
    private val OF_SPINS = setOf(
        "rotational_temperature",
        "rotational_over_translational",
        "mean_spin_x",
        "mean_spin_y",
        "mean_spin_z",
    )
    private val OF_HEIGHT = setOf("scale_height", "midplane_filling_factor")
    private val OF_COLLISIONS = setOf("collisions_per_particle", "compressibility", "reduced_pressure")
    private val OF_STRESS = setOf(
        "viscosity_translational",
        "viscosity_collisional",
        "viscosity_gravitational",
        "viscosity_total",
        "viscosity_total_in_run_units",
        "reduced_shear_stress",
        "shear_work_over_dissipation",
    )
    private val OF_ROWS = OF_SPEED + OF_COLLISIONS + OF_STRESS + PerturbedSheet.FLUXES +
        setOf("scale_height", "velocity_dispersion_total")
    private val FOLLOWING = OF_SPEED + OF_COLLISIONS + OF_STRESS -
        setOf("compressibility", "shear_work_over_dissipation", "wall_work_over_dissipation")
}
