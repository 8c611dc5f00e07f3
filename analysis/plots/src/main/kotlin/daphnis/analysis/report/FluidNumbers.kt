package daphnis.analysis.report

import daphnis.analysis.correlation.ContactValues
import daphnis.analysis.correlation.LongWaveLimit
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.theory.HardDiscs
import daphnis.analysis.theory.HardSpheres

/** Numbers of the structure of a fluid of equal elastic spheres or discs at rest: S(0⁺) and g at contact. */
internal class FluidNumbers(private val study: Study) : Section {
    private val diameter = 2 * study.bulk.typicalRadius
    private val filling = study.bulk.fillingFactor
    private val isPlane = study.last.boundary.space.isPlane
    private val both = listOf(LongWaveLimit(REACH / diameter), ContactValues())
    private val averages = both.map { Averages(it) }

    override val heading = "Structure"
    override val over = study.overAverages
    override val isWritten = false
    override val applies: Boolean = study.physics?.let { ElasticGas.isSeen(it, study.last) } == true &&
        !study.isGrowing &&
        study.tooFew() == null &&
        isRoomy()

    private fun isRoomy() = study.boxes.boundaries.all { b ->
        (0 until study.last.dimensions).all { b.box.length(it) > 4 * diameter }
    }

    override fun add(state: State) {
        for (a in averages) a.add(state)
    }

    override fun write(page: ReportPage) = Unit

    override fun numbers(): List<NumberRow> {
        val rows = NumberRows(references())
        if (isFluid() && !averages[0].average(0).mean.isNaN()) {
            val note = "n kT times the isothermal compressibility"
            rows.average("structure_factor_zero", "structure factor S(0⁺)", averages[0].average(0), "", note)
        }
        rows.average("contact_value", "pair correlation at contact g(σ)", averages[1].average(0), "")
        return rows.list()
    }

    /** Neither begun as a crystal nor as dense as one: a crystal's S(k) at small k is no compressibility. */
    private fun isFluid() = study.physics?.placement?.isOrdered != true && !study.mayFreeze

    private fun references(): Map<String, Reference> {
        if (filling > (if (isPlane) MOST_OF_DISCS else MOST_OF_SPHERES)) return emptyMap()
        val contact =
            if (isPlane) HardDiscs.hendersonContact(filling) else HardSpheres.carnahanStarlingContact(filling)
        val zero =
            with(filling) {
                if (isPlane) HardDiscs.hendersonLongWaveLimit(this) else HardSpheres.carnahanStarlingLongWaveLimit(this)
            }
        val source = if (isPlane) EquationOfState.HENDERSON else EquationOfState.CARNAHAN
        return mapOf(
            "structure_factor_zero" to Reference(zero, ZERO_BOUND * zero, source),
            "contact_value" to Reference(contact, CONTACT_BOUND * contact, source),
        )
    }

    private companion object {
        /** k σ up to which waves are long. */
        const val REACH = 2.5
        const val MOST_OF_SPHERES = 0.45
        const val MOST_OF_DISCS = 0.5

        /** Of the equation of state, of the parabolas and of few hundred spheres, relative. */
        const val ZERO_BOUND = 0.03
        const val CONTACT_BOUND = 0.02
    }
}
