package daphnis.analysis.report

/**
 * The sections of a report in their order. Those that would mean nothing are left out, and the report says why.
 *
 * @param list makers of the sections behind that of the numbers
 */
internal class Sections(private val study: Study, list: List<(Study) -> Section> = LIST) {
    private val further: List<Section> = list.map { it(study) }.filter { it.applies }
    private val numbers = NumbersSection(study, further)
    private val all: List<Section> = listOf<Section>(numbers) + further
    private val averaged = study.averaged.toSet()
    private val followed = further.associateWith { it.followed.toSet() }

    /** Indices of the states that are needed, ascending. */
    val states: List<Int> = (averaged + followed.values.flatten()).sorted()

    /** Reads state [k] and shows it to the sections that want it. */
    fun add(k: Int) {
        val snapshot = study.input.snapshot(k)
        for ((section, wanted) in followed) if (k in wanted) section.follow(snapshot)
        if (k !in averaged) return
        val state = study.input.state(k, snapshot)
        study.motion.add(state)
        for (section in all) section.add(state)
    }

    /** Whether averages are over a time in which the run drifts. */
    val isDrifting: Boolean get() = study.judgement.isDrifting

    /** Whether there are too few rows in that time to tell. */
    val isUnjudged: Boolean get() = study.judgement.isUnjudged

    /** The rows of the table of numbers. */
    fun numbers(): List<NumberRow> = numbers.rows()

    /** The rows of that table, and those of the tables that sections have of their own. */
    fun allNumbers(): List<NumberRow> = numbers() + further.flatMap { it.ownNumbers() }

    /** Writes all onto [page]; [next] is told the heading of each before. */
    fun write(page: ReportPage, next: (String) -> Unit = {}) {
        val missing = ArrayList<String>()
        for (section in all.filter { it.isWritten }) {
            val why = section.leftOut
            if (why != null) {
                missing += "${section.heading}: $why."
                continue
            }
            next(section.heading)
            page.section(section.heading, section.over)
            section.write(page)
        }
        if (missing.isEmpty()) return
        page.section("Left out", "Sections that are not here, and why.")
        page.list(missing)
    }

    companion object {
        /** Those that have numbers: all that it takes where nothing is written. */
        val WITH_NUMBERS: List<(Study) -> Section> =
            listOf(
                ::WaveSection,
                ::FluidNumbers,
                ::MaterialSection,
                ::MoonletSection,
                ::SatelliteSection,
                ::DiffusionSection,
                ::InsertionSection,
                ::OrderSection,
                ::ClusterSection,
                ::SourcesSection,
            )

        /** Those that have numbers in tables of their own, too. */
        val WITH_OWN_NUMBERS: List<(Study) -> Section> = WITH_NUMBERS + ::StructureSection

        private val LIST: List<(Study) -> Section> = listOf(
            ::PictureSection,
            ::EvolutionSection,
            ::SourcesSection,
            ::PerturbedSection,
            ::WaveSection,
            ::StreamlineSection,
            ::ProfilesSection,
            ::EllipsoidSection,
            ::SizeClassSection,
            ::SpinSection,
            ::MaterialSection,
            ::MoonletSection,
            ::SatelliteSection,
            ::DiffusionSection,
            ::RelaxationSection,
            ::FluidNumbers,
            ::FlowSection,
            ::StructureSection,
            ::InsertionSection,
            ::OrderSection,
            ::CoolingSection,
            ::ClusterSection,
            ::OccultationSection,
            ::BrightnessSection,
            ::ImpactsSection,
            ::RunSection,
        )
    }
}
