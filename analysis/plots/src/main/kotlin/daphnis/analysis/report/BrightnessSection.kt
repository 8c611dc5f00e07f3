package daphnis.analysis.report

import daphnis.analysis.insitu.State

/** How bright the patch is in the light that it scatters, where that is asked for. */
internal class BrightnessSection(private val study: Study) : Section {
    private val options = study.options.brightness

    override val heading = "Brightness"
    override val over = "What an eye sees of the light that the ${study.place} scatters. ${study.overAverages}"
    override val applies = options != null
    override val leftOut = study.unlit

    private val parts: List<LightPart> = if (options == null || leftOut != null) {
        emptyList()
    } else {
        listOfNotNull(
            BrightnessGridPart(study, options),
            BrightnessPhasePart(study, options),
            options.observed?.let { ObservedBrightnessPart(study, options, it) },
        )
    }

    override fun add(state: State) {
        for (part in parts) part.add(state)
    }

    override fun ownNumbers(): List<NumberRow> = parts.flatMap { it.rows() }

    override fun write(page: ReportPage) {
        if (options != null) page.paragraph(model(options))
        for (part in parts) part.write(page)
    }

    private fun model(options: BrightnessOptions): String {
        val orders = if (options.orders == 1) {
            "Light is scattered once."
        } else {
            "Light is scattered up to ${options.orders} times, from the second time on by Monte Carlo."
        }
        val isWhole = options.law.table?.let { it.covers(0.0) && it.covers(Math.PI) } ?: true
        val share = ReportText.short(options.law.sphericalAlbedo)
        val alone = if (isWhole) " A sphere alone scatters $share of the light that falls on it." else ""
        return "The spheres have ${options.law.words}. $orders$alone"
    }
}
