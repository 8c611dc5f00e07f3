package daphnis.analysis.theory

import kotlin.math.PI
import kotlin.math.ln

/**
 * The fluid of hard spheres of several sizes by Boublík 1970, J. Chem. Phys. 53, 471, Grundke & Henderson 1972, Mol.
 * Phys. 24, 269, and Mansoori, Carnahan, Starling & Leland 1971, J. Chem. Phys. 54, 1523 (BMCSL). For one size it is
 * [HardSpheres.carnahanStarling], 0.3 % from the truth at most. Contact values of diameters 0.6 and 1 at a filling
 * factor of 0.3 are within 2 % and four errors of those of a run; denser fluids and other ratios were not tried. Discs
 * have [HardDiscs.contactValue].
 *
 * @param diameters one of each kind; 0 is of points
 * @param densities how many of it are in a unit of volume, 0 or more
 * @throws IllegalArgumentException when lengths differ, there is no sphere, or no room for them
 */
public class HardSphereMixture(diameters: DoubleArray, densities: DoubleArray) {
    private val diameters = diameters.copyOf()
    private val moments: DoubleArray

    init {
        require(diameters.size == densities.size) { "${diameters.size} diameters, but ${densities.size} densities" }
        require(diameters.all { it >= 0 && it.isFinite() }) { "diameters must be 0 or more" }
        require(densities.all { it >= 0 && it.isFinite() } && densities.any { it > 0 }) {
            "densities must be 0 or more, and one of them above"
        }
        moments = DoubleArray(MOMENTS) { k ->
            diameters.indices.sumOf { i ->
                var power = PI / 6 * densities[i]
                repeat(k) { power *= diameters[i] }
                power
            }
        }
        require(moments[3] < 1) { "the filling factor is ${moments[3]}; it must be below 1" }
    }

    /** Filling factor φ of all together. */
    public val filling: Double get() = moments[3]

    /** p V/(N kT). */
    public val compressibility: Double
        get() {
            val free = 1 - moments[3]
            val pairs = 3 * moments[1] * moments[2] / (moments[0] * free * free)
            val cube = moments[2] * moments[2] * moments[2]
            return 1 / free + pairs + cube * (3 - moments[3]) / (moments[0] * free * free * free)
        }

    /**
     * μ_ex/kT of one more sphere of [diameter], of one of the kinds or of none: −ln of the probability that it fits in
     * at a random place. A cubic in the diameter, the derivative of the free energy by the moments of the sizes (Reiss,
     * Frisch & Lebowitz 1959, J. Chem. Phys. 31, 369, for its form); −ln(1 − φ) of a point is exact.
     *
     * @throws IllegalArgumentException for a diameter that is negative or not finite
     */
    public fun excessChemicalPotential(diameter: Double): Double {
        require(diameter >= 0 && diameter.isFinite()) { "the diameter is $diameter; it must be 0 or more" }
        val free = 1 - moments[3]
        val log = ln(free)
        // Of the free energy (x₂³/x₃² − x₀) ln(1 − x₃) + 3 x₁x₂/(1 − x₃) + x₂³/(x₃ (1 − x₃)²) by each of the moments x.
        val ratio = moments[2] / moments[3]
        val first = 3 * moments[2] / free
        val second = 3 * ratio * ratio * log + 3 * moments[1] / free + 3 * moments[2] * ratio / (free * free)
        val cube = moments[2] * ratio * ratio
        val third = -2 * ratio * ratio * ratio * log - (cube - moments[0]) / free +
            3 * moments[1] * moments[2] / (free * free) + cube * (2 * moments[3] / free - 1) / (free * free)
        return -log + diameter * (first + diameter * (second + diameter * third))
    }

    /** g_ij at contact of spheres of the kinds [first] and [second]. */
    public fun contactValue(first: Int, second: Int): Double {
        val free = 1 - moments[3]
        val sum = diameters[first] + diameters[second]
        // Half the harmonic mean of both; none of two points.
        val reduced = if (sum > 0) diameters[first] * diameters[second] / sum else 0.0
        val s = reduced * moments[2] / free
        return (1 + 3 * s + 2 * s * s) / free
    }

    private companion object {
        const val MOMENTS = 4
    }
}
