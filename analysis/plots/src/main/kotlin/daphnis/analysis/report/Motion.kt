package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import daphnis.analysis.profile.FourthCumulants
import daphnis.analysis.profile.LocalDispersion
import daphnis.analysis.profile.Profile
import daphnis.analysis.profile.VelocityEllipsoid
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.transport.PerturbedTransport
import daphnis.analysis.transport.Transport
import daphnis.core.boundary.isChanging
import daphnis.core.population.VelocityMoments
import daphnis.core.run.SeriesColumns
import daphnis.core.run.TransportColumns

/** How the particles move on average: from the rows of transport.csv where there are any, else from the states. */
internal class Motion(private val input: AnalysisInput, from: Double, last: State) {
    private val states = Averages(OF_STATE)
    private val near = if (input.omega == null || !input.hasVelocities) {
        null
    } else {
        LocalDispersion.fitting(last)?.let { Averages(it) }
    }

    /** Of a gas: a ring is far from a Maxwellian in other ways. */
    private val cumulants = if (input.omega == null && input.hasVelocities) Averages(FourthCumulants()) else null

    /** Null for spheres without spins. */
    val rotation: Rotation? = if (last.population.hasSpin) Rotation(input, from, last) else null

    /** Of a sheet that is perturbed, over whole periods; null for others, and without a period. */
    val perturbed: PerturbedTransport? =
        PerturbedSheet.period(input, last)?.let { period ->
            val rows = input.transport?.from(from)?.takeIf { it.size >= 2 }
            rows?.let { PerturbedTransport(it, last.boundary, period) }?.takeIf { it.periods > 0 }
        }

    /** What the rows from the time of averages on tell; null without two of them. */
    val transport: Transport? =
        input.transport?.from(from)?.takeIf { it.size >= 2 }?.let { all ->
            // In a perturbed sheet the flow is another at any time, and a period is whole.
            val it = perturbed?.let { all.until(it.ends().last() * (1 + ROUNDING)) } ?: all
            val flow = last.boundary.meanFlow.takeUnless { last.boundary.isChanging }
            Transport(
                it,
                flow?.rate ?: 0.0,
                potential(it[TransportColumns.TIME]),
                flow?.flowAxis ?: 0,
                last.boundary.space,
            )
        }

    /** Of discs the area fraction; it changes where particles come and leave. */
    private val fillings = Averages(
        Measure { state ->
            val there = (0 until state.population.size).filter { state.isParticle(it) }
            val filled = there.sumOf { state.boundary.space.volume(state.population.radius[it]) }
            doubleArrayOf(filled / state.boundary.volume)
        },
    )
    val fillingFactor: BlockAverage get() = fillings.average(0)

    /** Number of states so far. */
    val size: Int get() = states.size

    /** Takes in one more state. */
    fun add(state: State) {
        states.add(state)
        fillings.add(state)
        near?.add(state)
        cumulants?.add(state)
        rotation?.add(state)
    }

    /** The fourth cumulant [column] of [FourthCumulants] of a gas, from the states. */
    fun cumulant(column: String): BlockAverage =
        checkNotNull(cumulants).average(FourthCumulants.COLUMNS.indexOf(column))

    /** ⟨c_a c_b⟩: xx, yy, zz, xy. */
    fun moment(name: String): BlockAverage =
        transport?.moment(name) ?: states.average(VelocityMoments.COMPONENTS.indexOf(name))

    val dispersion: BlockAverage get() = transport?.dispersion ?: average(OfState.DISPERSION)
    val totalDispersion: BlockAverage get() = transport?.totalDispersion ?: average(OfState.TOTAL)

    /** Of near neighbours, from the states; NaN in Hill's frame only where there are too few, elsewhere always. */
    val thermalDispersion: BlockAverage get() =
        near?.takeIf { it.size > 0 }?.average(LocalDispersion.COLUMNS.indexOf("c2"))?.root()
            ?: BlockAverage(Double.NaN, Double.NaN, 0)
    val scaleHeight: BlockAverage get() = transport?.scaleHeight ?: average(OfState.SCALE_HEIGHT)
    val temperature: BlockAverage get() = transport?.temperature ?: average(OfState.TEMPERATURE)
    val ellipsoid: VelocityEllipsoid get() =
        VelocityEllipsoid.of(moment("xx").mean, moment("yy").mean, moment("zz").mean, moment("xy").mean)
    val orientation: BlockAverage get() =
        transport?.orientation ?: BlockAverage(ellipsoid.orientation, Double.NaN, states.size)

    /** Of the states, as transport.csv does not hold it. */
    val middlePlane: BlockAverage get() = average(OfState.MIDDLE_PLANE)

    /** What of the states tells whether they are steady, from the time [from] on; null where nothing does. */
    fun history(from: Double): History? {
        val times = DoubleArray(size) { from + it }
        fun of(number: OfState) = states.series(column(number))
        return when {
            input.hasVelocities -> History("granular temperature", times, of(OfState.TEMPERATURE))
            input.omega != null -> History("scale height", times, of(OfState.SCALE_HEIGHT))
            else -> null
        }
    }

    /** Energy of the forces and of spins at [times], from series.csv; null unless it has a row at each of them. */
    private fun potential(times: DoubleArray): DoubleArray? {
        val series = input.series?.takeIf { SeriesColumns.POTENTIAL_ENERGY in it } ?: return null
        val spins = if (SeriesColumns.ROTATIONAL_ENERGY in series) series[SeriesColumns.ROTATIONAL_ENERGY] else null
        val energy = series[SeriesColumns.TIME].indices.associate {
            series[SeriesColumns.TIME][it] to series[SeriesColumns.POTENTIAL_ENERGY][it] + (spins?.get(it) ?: 0.0)
        }
        return DoubleArray(times.size) { energy[times[it]] ?: return null }
    }

    private fun average(number: OfState) = states.average(column(number))

    private fun column(number: OfState) = VelocityMoments.COMPONENTS.size + number.ordinal

    /** What is measured of one state beside the moments. */
    private enum class OfState(val of: (State, VelocityMoments) -> Double) {
        DISPERSION({ _, moments -> moments.dispersion }),
        TOTAL({ _, moments -> moments.totalDispersion }),
        SCALE_HEIGHT({ _, moments -> moments.scaleHeight }),
        TEMPERATURE({ _, moments -> moments.temperature }),

        /** Filling factor of a slab a fifth of the smallest radius thick. */
        MIDDLE_PLANE({ state, moments ->
            val half = (state.population.radius.minOrNull() ?: 1.0) / 10
            val slab = Profile(2, moments.centreZ - half, moments.centreZ + half, 1).of(state)
            slab[Profile.COLUMNS.indexOf("filling_factor")]
        }),
    }

    private companion object {
        const val ROUNDING = 1e-9

        val OF_STATE: Measure = Measure { state ->
            val m = VelocityMoments.within(state.boundary, state.population, state.frequencies, state.firstBody)
            m.moments + DoubleArray(OfState.entries.size) { OfState.entries[it].of(state, m) }
        }
    }
}
