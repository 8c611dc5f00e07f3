package daphnis.analysis.report

import daphnis.analysis.correlation.ContactValues
import daphnis.analysis.correlation.PairCorrelation
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.theory.HardDiscs
import daphnis.analysis.theory.HardSphereMixture
import daphnis.core.format.WholeFile
import java.nio.file.Files

/** Pairs of each two kinds of particles of a mixture, and contact values g_ab(σ_ab) in a box without faces. */
internal class MixturePart(private val study: Study, private val kinds: NamedGroups) : Part {
    private val dimensions = study.last.dimensions
    private val isBox = !study.isRing &&
        study.boxes.boundaries.all { b ->
            (0 until dimensions).all { b.hasImages(it) && b.box.length(it) > 2.2 * study.bulk.largestRadius }
        }
    private val contact = ContactValues(kinds.groups)
    private val contacts = if (isBox) Averages(contact) else null

    /** Of materials the section on these has the pairs. */
    private val pairs = if (kinds.kind == "size") correlation() else null
    private val besides = pairs?.let { Averages(it) }

    private fun correlation(): PairCorrelation {
        val room = study.boxes.boundaries.minOf { PairCorrelation.farthest(it) }
        return PairCorrelation(minOf(room, RADII * 2 * study.bulk.typicalRadius), BINS, 0.0, kinds.groups)
    }

    override fun add(state: State) {
        contacts?.add(state)
        besides?.add(state)
    }

    override fun write(page: ReportPage) {
        if (pairs != null) {
            val x = DoubleArray(pairs.bins) { pairs.centre(it) }
            val inPlane = PairCorrelation.isInPlane(study.last.boundary) && dimensions == 3
            val argument = (if (inPlane) "distance in the plane" else "distance r") to study.units.length
            kinds.write(study, page, "pair-correlation", x, besides!!, "g", argument, "r", PAIRS) { a, b ->
                pairs.first(a, b)
            }
        }
        val rows = rows().ifEmpty { return }
        page.numbers(rows)
        Files.createDirectories(study.tables)
        val lines = kinds.pairs.zip(rows).map { (pair, row) ->
            val error = if (row.error.isNaN()) "" else row.error
            "${kinds.names[pair.first]},${kinds.names[pair.second]},${row.value},$error,${row.reference?.value ?: ""}"
        }
        val header = "first,second,contact_value,contact_value_error,reference"
        WholeFile.write(
            study.tables.resolve("contact-values.csv"),
            (listOf(header) + lines).joinToString("\n", postfix = "\n"),
        )
    }

    private fun rows(): List<NumberRow> {
        val all = contacts ?: return emptyList()
        val rows = NumberRows(kinds.pairs.mapNotNull { p -> theory(p)?.let { kinds.name(p) to it } }.toMap())
        for (pair in kinds.pairs) {
            val average = all.average(contact.at(pair.first, pair.second))
            rows.average(kinds.name(pair), "g at contact, ${kinds.name(pair)}", average, "")
        }
        return study.judgement.shown(rows.list())
    }

    /** Of elastic spheres or discs of one radius of each kind, at rest. */
    private fun theory(pair: Pair<Int, Int>): Reference? {
        val scenario = study.physics ?: return null
        val filling = study.bulk.fillingFactor
        val most = if (dimensions == 2) MOST_OF_DISCS else MOST_OF_SPHERES
        if (!ElasticGas.isAtRest(scenario, study.last) || study.isGrowing || filling > most) return null
        val state = study.last
        val radii = kinds.names.indices.map { g ->
            (0 until state.population.size)
                .filter { state.isParticle(it) && kinds.groups.of(state, it) == g }
                .map { state.population.radius[it] }
        }
        if (radii.any { it.isNotEmpty() && !ElasticGas.areEqual(it.toDoubleArray()) }) return null
        val diameters = DoubleArray(radii.size) { radii[it].firstOrNull()?.times(2) ?: 0.0 }
        val box = state.boundary.box
        val space = if (dimensions == 2) state.area else box.volume
        val densities = DoubleArray(radii.size) { radii[it].size / space }
        val value = if (dimensions == 2) {
            HardDiscs.contactValue(pair.first, pair.second, diameters, densities)
        } else {
            HardSphereMixture(diameters, densities).contactValue(pair.first, pair.second)
        }
        val source = if (dimensions == 2) "Jenkins & Mancini 1987" else "Boublík 1970, Mansoori & al. 1971"
        return Reference(value, BOUND * value, source)
    }

    private companion object {
        const val RADII = 8.0
        const val BINS = 80
        const val MOST_OF_SPHERES = 0.45
        const val MOST_OF_DISCS = 0.5
        const val BOUND = 0.03
        const val PAIRS =
            "Pairs of each two sizes at a distance, over those of particles without correlation; sizes are " +
                "radii."
    }
}
