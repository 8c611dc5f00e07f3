package daphnis.analysis.report

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.analysis.wave.WaveAmplitudes
import daphnis.analysis.wave.WaveGrowth
import daphnis.core.wave.ModeQuantity
import java.util.Locale
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.sin

/**
 * The waves of a ring from modes.csv: how strong each mode is, how fast it grows, its frequency and direction, which is
 * the strongest over time, and a picture of the surface density over time.
 */
internal class WaveSection(private val study: Study) : Section {
    private val waves = study.waves
    private val units = study.units
    private val scale = study.scale

    override val heading = "Waves"
    override val over = "Fourier modes along x, from modes.csv: over the whole run, and averages from time " +
        "${study.time(study.from)} on."
    override val applies = study.isRing && study.input.modes != null
    override val leftOut = when {
        waves == null -> "modes.csv needs four states in every epicyclic period, and one period at least"
        else -> study.tooFew()
    }

    override fun numbers(): List<NumberRow> {
        val waves = waves ?: return emptyList()
        if (leftOut != null) return emptyList()
        val rows = NumberRows()
        val strongest = waves.strongest
        val wavelength = waves.wavelength(strongest)
        rows.exact("wave_wavelength", "wavelength of the strongest mode", wavelength, units.length)
        val speed = waves.rms(ModeQuantity.VELOCITY_X, strongest) * (1 / scale.speed)
        rows.average("wave_rms_vx", "rms v_x of this mode", speed, scale.speedName, "of momentum over ⟨Σ⟩")
        val frequency = waves.frequency(strongest) * (1 / omega)
        if (!frequency.mean.isNaN()) {
            rows.average("wave_frequency", "frequency of this mode", frequency, "Ω")
            val note = "1 outward, 0 standing, −1 inward"
            rows.average("wave_direction", "direction of this mode", waves.direction(strongest), "", note)
        }
        val first = waves.wavelength(waves.first)
        rows.exact("wave_first_wavelength", "wavelength of the mode that is strongest first", first, units.length)
        waves.growth(waves.first)?.let {
            val why = if (it.isGrowing) {
                "of small amplitudes, from ${time(it.first)} to ${time(it.last + 1)}"
            } else {
                NOT_GROWING
            }
            val (rate, error) = it.rate * scale.time to it.rateError * scale.time
            rows.change("wave_growth_rate", "growth rate of that mode", rate, error, scale.rateName, why)
            val (frequency, its) = it.frequency / omega to it.frequencyError / omega
            if (!frequency.isNaN()) {
                rows.change("wave_growth_frequency", "frequency of that mode in this time", frequency, its, "Ω")
            }
        }
        return rows.list()
    }

    private val omega = study.input.omega ?: Double.NaN

    private fun time(period: Int) =
        ReportText.short((waves!!.table.times.first() + period * waves.period) / scale.time) + " orbits"

    override fun write(page: ReportPage) {
        val waves = waves ?: return
        speeds(page, waves)
        wavelengths(page, waves)
        density(page, waves)
        byMode(waves)
        blocks(waves)
    }

    private fun speeds(page: ReportPage, waves: Waves) {
        val time = times(waves)
        val shown = waves.modes.take(MOST_CURVES)
        fun series(value: (WaveAmplitudes, Int) -> Double) = waves.modes.map { m ->
            DoubleArray(waves.periods) { value(waves.amplitude(m), it) / scale.speed }
        }
        val speeds = series(WaveAmplitudes::rmsSpeed)
        val coherent = series(WaveAmplitudes::coherentSpeed)
        // Of all lengths as many decimals as give the shortest three digits.
        val decimals = maxOf(0, 2 - floor(log10(waves.wavelength(shown.last()))).toInt())
        val curves = shown.map {
            val length = String.format(Locale.ROOT, "%.${decimals}f", waves.wavelength(it))
            Curve("λ = ${UnitNames.amount(length, units.length)}", time, speeds[it - 1])
        }
        val figure = Chart.lines(
            curves,
            UnitNames.axis("time", scale.timeName),
            UnitNames.axis("rms radial velocity", scale.speedName),
            logY = true,
            vertical = study.from / scale.time,
        )
        val caption =
            "Root mean square of v_x in each mode by epicyclic period: of the momentum density over the mean " +
                "surface density, which in steep waves is more than v_x. Averages begin at the dashed line. " +
                "wave-history.csv also has that part which turns as epicycles do, from which growth is found."
        study.draw(page, figure, "wave-speeds", "strength of each mode over time", caption)
        val columns = waves.modes.map { Column("rms_vx_$it", scale.speedName, speeds[it - 1]) } +
            waves.modes.map { Column("coherent_vx_$it", scale.speedName, coherent[it - 1]) }
        val strongest = DoubleArray(waves.periods) { waves.wavelength(waves.strongest(it)) }
        val all = listOf(Column("time", scale.timeName, time), Column("strongest_wavelength", units.length, strongest))
        Table("wave-history", all + columns).write(study.tables)
    }

    private fun times(waves: Waves) = DoubleArray(waves.periods) { waves.amplitude(1).time(it) / scale.time }

    private fun wavelengths(page: ReportPage, waves: Waves) {
        val wavelength = DoubleArray(waves.periods) { waves.wavelength(waves.strongest(it)) }
        val (reference, words) = reference(waves)
        val figure = Chart.lines(
            listOf(Curve("strongest mode", times(waves), wavelength)),
            UnitNames.axis("time", scale.timeName),
            study.lengthAxis("wavelength"),
            horizontal = reference,
            joined = false,
        )
        study.draw(
            page,
            figure,
            "wavelength",
            "wavelength of the strongest mode over time",
            "Wavelength of the strongest mode by epicyclic period.$words",
        )
    }

    /** A wavelength to compare with, and words: with self-gravity the critical one, else that which grows first. */
    private fun reference(waves: Waves): Pair<Double?, String> {
        val critical = study.bulk.criticalWavelength
        if (critical > 0) return critical to " The dashed line is Toomre's critical wavelength, 4π² G Σ/κ²."
        val first = waves.first.takeIf { waves.growth(it)?.isGrowing == true } ?: return null to ""
        return waves.wavelength(first) to " The dashed line is the wave that grows first."
    }

    /** Σ(x, t) over the last periods, as the sum of all modes. */
    private fun density(page: ReportPage, waves: Waves) {
        val table = waves.table
        val end = table.times.last()
        val begin = maxOf(table.times.first(), end - SHOWN_PERIODS * waves.period)
        val rows = table.times.indices.filter { table.times[it] >= begin }
        val stride = (rows.size + MOST_TIMES - 1) / MOST_TIMES
        val shown = rows.filterIndexed { k, _ -> k % stride == 0 }
        val box = study.last.boundary.box
        val places = maxOf(PLACES, PLACES_PER_WAVE * table.modes)
        val x = DoubleArray(places) { box.lowerX + (it + 0.5) * box.length(0) / places }
        val values = DoubleArray(places * shown.size)
        for (m in waves.modes) {
            val re = table.real(ModeQuantity.DENSITY, m)
            val im = table.imaginary(ModeQuantity.DENSITY, m)
            for (i in x.indices) {
                val c = cos(table.wavenumber(m) * x[i])
                val s = sin(table.wavenumber(m) * x[i])
                for ((j, row) in shown.withIndex()) values[i * shown.size + j] += re[row] * c - im[row] * s
            }
        }
        val time = DoubleArray(shown.size) { table.times[shown[it]] / scale.time }
        val figure = Chart.map(
            x,
            time,
            values,
            UnitNames.axis("time", scale.timeName),
            study.lengthAxis("radial position x"),
            "δΣ/⟨Σ⟩",
            isToScale = false,
        )
        val caption =
            "Surface density over its mean, less 1, over the last part of the run, as the sum of all modes. " +
                "Crests that go outward rise to the right."
        study.draw(page, figure, "wave-density", "surface density over place and time", caption, MAP_HEIGHT)
        Table(
            "wave-density",
            listOf(
                Column("time", scale.timeName, DoubleArray(values.size) { time[it % time.size] }),
                Column("x", units.length, DoubleArray(values.size) { x[it / time.size] }),
                Column("density_contrast", "", values),
            ),
        ).write(study.tables)
    }

    private fun byMode(waves: Waves) {
        val modes = waves.modes.toList()
        fun column(name: String, unit: String, value: (Int) -> Double) =
            Column(name, unit, DoubleArray(modes.size) { value(modes[it]) })

        fun growth(name: String, unit: String, value: (WaveGrowth) -> Double) =
            column(name, unit) { m -> waves.growth(m)?.let(value) ?: Double.NaN }

        fun error(average: BlockAverage) = study.judgement.error(average)
        val speeds = modes.map { waves.rms(ModeQuantity.VELOCITY_X, it) * (1 / scale.speed) }
        val densities = modes.map { waves.rms(ModeQuantity.DENSITY, it) }
        val frequencies = modes.map { waves.frequency(it) * (1 / omega) }
        val directions = modes.map { waves.direction(it) }
        Table(
            "waves",
            listOf(
                column("mode", "") { it.toDouble() },
                column("wavelength", units.length) { waves.wavelength(it) },
                column("rms_vx", scale.speedName) { speeds[it - 1].mean },
                column("rms_vx_error", scale.speedName) { error(speeds[it - 1]) },
                column("density", "") { densities[it - 1].mean },
                column("density_error", "") { error(densities[it - 1]) },
                column("frequency", "Ω") { frequencies[it - 1].mean },
                column("frequency_error", "Ω") { error(frequencies[it - 1]) },
                column("direction", "") { directions[it - 1].mean },
                column("direction_error", "") { error(directions[it - 1]) },
                growth("growth_rate", scale.rateName) { it.rate * scale.time },
                growth("growth_rate_error", scale.rateName) { it.rateError * scale.time },
                growth("growth_frequency", "Ω") { it.frequency / omega },
                growth("growth_frequency_error", "Ω") { it.frequencyError / omega },
                growth("is_growing", "") { if (it.isGrowing) 1.0 else 0.0 },
                growth("growth_from", scale.timeName) { timeOf(waves, it.first) },
                growth("growth_to", scale.timeName) { timeOf(waves, it.last + 1) },
            ),
        ).write(study.tables)
    }

    private fun timeOf(waves: Waves, period: Int) = (waves.table.times.first() + period * waves.period) / scale.time

    /** Root mean squares over blocks of orbits, of all that the modes have. */
    private fun blocks(waves: Waves) {
        val start = waves.table.times.first()
        val orbits = (waves.table.times.last() - start) / scale.time
        val count = Math.ceil(orbits / BLOCK - ROUNDING).toInt().coerceAtLeast(1)
        fun begin(k: Int) = start + k * BLOCK * scale.time
        fun rms(quantity: ModeQuantity, m: Int, unit: Double) =
            DoubleArray(count) { waves.rms(quantity, m, begin(it), begin(it + 1)) / unit }
        val places = listOf(
            Column("from", scale.timeName, DoubleArray(count) { begin(it) / scale.time }),
            Column("to", scale.timeName, DoubleArray(count) { begin(it + 1) / scale.time }),
        )
        val speeds = waves.modes.map {
            Column("rms_vx_$it", scale.speedName, rms(ModeQuantity.VELOCITY_X, it, scale.speed))
        }
        val densities = waves.modes.map { Column("density_$it", "", rms(ModeQuantity.DENSITY, it, 1.0)) }
        Table("wave-blocks", places + speeds + densities).write(study.tables)
    }

    private companion object {
        const val MOST_CURVES = 6
        const val SHOWN_PERIODS = 8
        const val MOST_TIMES = 160
        const val PLACES = 40
        const val PLACES_PER_WAVE = 4
        const val MAP_HEIGHT = 360
        const val BLOCK = 5
        const val ROUNDING = 1e-6
        const val NOT_GROWING = "over the whole run: no time of growth is seen"
    }
}
