package daphnis.analysis.report

import daphnis.analysis.plot.PatchPicture

/** The sections of a report in their order. Those that would mean nothing are left out, and the report says why. */
internal class Sections(private val study: Study) {
    private val input = study.input
    private val structure = StructureSections(input, study.measures, study.numbers, study.plots, study.tables)
    private val diffusion = DiffusionSection(study)

    private val all: List<Section> = listOfNotNull(
        NumbersSection(study, diffusion.rows()),
        PlainSection("The patch", "${study.overLast} To scale.", body = ::pictures),
        EvolutionSection(study),
        if (study.isRing) streamlines() else null,
        ProfilesSection(study),
        EllipsoidSection(study),
        SizeClassSection(study),
        diffusion,
        if (!study.isRing && study.last.boundary.meanFlow != null) FlowSection(study) else null,
        PlainSection(
            "Structure",
            "How particles stand to each other. ${study.overAverages}",
            notCompact() ?: study.tooFew(LEAST),
            body = structure::correlations,
        ),
        PlainSection(
            "Occultation",
            "What a star behind the patch would show. ${study.overAverages}",
            notSlab() ?: study.tooFew(LEAST),
            body = structure::occultation,
        ),
        PlainSection("Impacts", "How fast spheres meet. All collisions of the run.", noImpacts(), structure::impacts),
        RunSection(study),
    )

    fun write(page: ReportPage) {
        val missing = ArrayList<String>()
        for (section in all) {
            val why = section.leftOut
            if (why != null) {
                missing += "${section.heading}: $why."
                continue
            }
            page.section(section.heading, section.over)
            section.write(page)
        }
        if (missing.isEmpty()) return
        page.section("Left out", "Sections that would mean nothing here.")
        page.list(missing)
    }

    private fun pictures(page: ReportPage) {
        val last = study.last
        val picture = PatchPicture(last, study.units.length)
        val part = if (last.boundary.box.length(1) > 4 * last.boundary.box.length(0)) {
            " The first part of its length."
        } else {
            ""
        }
        val axes = if (study.isRing) "orbital motion to the right, outward up" else "y to the right, x up"
        val above = picture.writeAbove(study.plots, "patch-above")
        val caption = "From above; $axes; higher spheres are brighter. The bar is ${picture.bar}.$part"
        page.png(above, "the patch from above", caption)
        val side = picture.writeSide(study.plots, "patch-side")
        page.png(
            side,
            "the patch from the side",
            "From the side; y to the right, z up; nearer spheres are brighter.$part",
        )
    }

    private fun streamlines() = PlainSection("Streamlines", study.overLast, study.tooFew(StreamlineSection.LEAST)) {
        StreamlineSection(input, study.plots, study.tables, study.options).write(it, study.last)
    }

    private fun notCompact(): String? =
        if (study.measures.isCompact) null else "the patch is more than twenty times as long as wide"

    private fun notSlab(): String? = if (study.measures.isSlab) null else "the box is filled above and below"

    private fun noImpacts(): String? {
        if (input.directory == null) return "a file of states does not hold them"
        val impacts = input.impacts ?: return "the run did not write them; it does with output.transportEvery"
        return if (impacts.size < 2) "there are too few collisions" else null
    }

    private companion object {
        /** Particles below which averages over them mean nothing. */
        const val LEAST = ProfilesSection.LEAST
    }
}
