package daphnis.analysis.report

/** Compressibility P V/(N kT) of the fluid of equal hard spheres, and of equal hard discs, by filling factor. */
internal object EquationOfState {
    const val CARNAHAN = "Carnahan & Starling 1969"
    const val HENDERSON = "Henderson 1975"

    /** Carnahan & Starling 1969, J. Chem. Phys. 51, 635. */
    fun ofSpheres(filling: Double): Double {
        val free = 1 - filling
        return 1 + 4 * filling * (1 - filling / 2) / (free * free * free)
    }

    /** Henderson 1975, Mol. Phys. 30, 971. */
    fun ofDiscs(filling: Double): Double = (1 + filling * filling / 8) / ((1 - filling) * (1 - filling))
}
