package daphnis.analysis.report

import daphnis.analysis.table.UnitNames

/** What to say of a ring that drifts and has no steady part: a longer run does not help every one. */
internal object Unsteady {
    /** Total over thermal dispersion from which the motion is mostly that of waves. */
    private const val WAVES = 1.5

    private fun hasMoon(study: Study) = MoonEncounter.moons(study.input.scenario).any { !it.returns }

    fun advice(study: Study): String = transient(study)
        ?: advice(hasMoon(study), study.motion.totalDispersion.mean / study.motion.thermalDispersion.mean)

    /** Of a run into which spheres only come, or which they only leave; null for others. */
    private fun transient(study: Study): String? {
        val sources = study.input.scenario?.sources.orEmpty()
        return when {
            sources.isEmpty() || sources.any { it.takes } && sources.any { it.brings } -> null
            sources.any { it.brings } -> "spheres only come, so averages are over a time in which the run fills"
            else -> "spheres only leave, so averages are over a time in which the run empties"
        }
    }

    /** Of a ring in which a wave grows in the time averaged, which the one is that grows last; null for others. */
    fun growth(study: Study): String? {
        val waves = study.waves?.takeIf { !hasMoon(study) } ?: return null
        val mode = waves.growsLast ?: return null
        val growth = checkNotNull(waves.growth(mode))
        val grown = waves.endOf(growth.last).takeIf { it > study.from } ?: return null
        val rate = ReportText.withError(growth.rate * study.scale.time, growth.rateError * study.scale.time)
        val length = UnitNames.amount(ReportText.short(waves.wavelength(mode)), study.units.length)
        val isToEnd = grown > waves.table.times.last() - waves.period
        val until = if (isToEnd) {
            "to the end of the run: a longer run is needed"
        } else {
            "until time ${study.time(grown)}: averages mean something only from a later time on"
        }
        return "a wave $length long grows by a factor e^($rate) per orbit, $until"
    }

    /** Of a ring that a moon passes or not, by the [ratio] of total to thermal dispersion; NaN where it has none. */
    fun advice(hasMoon: Boolean, ratio: Double): String = when {
        hasMoon -> "a ring that a moon passes once has no steady state"
        ratio > WAVES ->
            "its motion is mostly that of waves (total over thermal dispersion ${ReportText.short(ratio)}), " +
                "which a longer run need not end"
        else -> "a longer run is needed"
    }
}
