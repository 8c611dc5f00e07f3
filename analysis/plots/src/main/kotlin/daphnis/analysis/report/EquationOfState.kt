package daphnis.analysis.report

import daphnis.analysis.theory.HardDiscs
import daphnis.analysis.theory.HardSpheres

/**
 * Compressibility P V/(N kT) of equal hard spheres, and of equal hard discs, by formulas that stay finite in what grows
 * beyond the fluid.
 */
internal object EquationOfState {
    const val CARNAHAN = "Carnahan & Starling 1969"
    const val HENDERSON = "Henderson 1975"

    fun ofSpheres(filling: Double): Double = HardSpheres.carnahanStarling(filling)

    fun ofDiscs(filling: Double): Double = HardDiscs.henderson(filling)
}
