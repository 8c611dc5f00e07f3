package daphnis.analysis.theory

/**
 * Contact values of g(r) in fluids of hard spheres, or discs, of several sizes.
 *
 * Spheres: Boublík 1970, J. Chem. Phys. 53, 471; Grundke & Henderson 1972, Mol. Phys. 24, 269; Mansoori, Carnahan,
 * Starling & Leland 1971, J. Chem. Phys. 54, 1523. Discs: Jenkins & Mancini 1987, J. Appl. Mech. 54, 27. Of one size they
 * are those of Carnahan & Starling and of Henderson. Good to 2 % or so up to filling factors of 0.45, of discs 0.5, while
 * diameters differ by less than a factor of three.
 */
public object HardMixture {
    /**
     * g_ab at contact of spheres of the diameters [a] and [b] in a fluid of the diameters [diameters], whose numbers in a
     * unit of volume are [densities].
     */
    @JvmStatic
    public fun contactOfSpheres(a: Double, b: Double, diameters: DoubleArray, densities: DoubleArray): Double {
        val filling = Math.PI / 6 * moment(3, diameters, densities)
        val squares = Math.PI / 6 * moment(2, diameters, densities)
        val void = 1 - filling
        val reduced = a * b / (a + b)
        return 1 / void + 3 * squares * reduced / (void * void) +
            2 * squares * squares * reduced * reduced / (void * void * void)
    }

    /** The same of discs; [densities] are numbers in a unit of area. */
    @JvmStatic
    public fun contactOfDiscs(a: Double, b: Double, diameters: DoubleArray, densities: DoubleArray): Double {
        val filling = Math.PI / 4 * moment(2, diameters, densities)
        val void = 1 - filling
        return 1 / void + 9.0 / 16 * 2 * a * b / (a + b) * Math.PI / 4 * moment(1, diameters, densities) / (void * void)
    }

    private fun moment(power: Int, diameters: DoubleArray, densities: DoubleArray): Double {
        require(diameters.size == densities.size) { "${diameters.size} diameters and ${densities.size} densities" }
        return diameters.indices.sumOf { densities[it] * Math.pow(diameters[it], power.toDouble()) }
    }
}
