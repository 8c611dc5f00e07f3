package daphnis.analysis.report

import daphnis.analysis.insitu.State

/** Moonlets, the bodies of a ring: what the ring around the first looks like, and where all of them went. */
internal class MoonletSection(study: Study) : Section {
    private val isRing = study.isRing && study.input.scenario?.bodies.orEmpty().isNotEmpty()
    private val body = if (isRing) Moonlet.firstOf(study) else null
    private val propeller = body?.let { PropellerPart(study, it) }
    private val walk = WalkPart(study)

    override val heading = "Moonlets"
    override val over = "Around the first: ${study.overAverages.replaceFirstChar { it.lowercase() }}" +
        if (walk.isKnown) " Orbits: rows of bodies.csv from time ${study.time(study.from)} on." else ""
    override val applies = isRing
    override val leftOut = if (body == null) "no body is left in the last state" else null

    override fun add(state: State) {
        propeller?.add(state)
    }

    override fun numbers(): List<NumberRow> = if (body == null) emptyList() else propeller!!.numbers() + walk.numbers()

    override fun write(page: ReportPage) {
        propeller?.write(page)
        walk.write(page)
    }
}

/**
 * The first of the bodies that are left.
 *
 * @property hillRadius (G m/3Ω²)^⅓; NaN where G is not known
 */
internal class Moonlet private constructor(val id: Int, val radius: Double, val hillRadius: Double) {
    companion object {
        fun firstOf(study: Study): Moonlet? {
            val p = study.last.population
            val at = (0 until p.size).filter { study.input.isBody(p.id[it]) }.minByOrNull { p.id[it] } ?: return null
            val omega = study.input.omega ?: return null
            val g = study.input.scenario?.gravitationalConstant ?: Double.NaN
            return Moonlet(p.id[at], p.radius[at], Math.cbrt(g * p.mass[at] / (3 * omega * omega)))
        }
    }
}
