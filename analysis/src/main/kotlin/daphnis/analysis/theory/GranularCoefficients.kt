package daphnis.analysis.theory

import kotlin.math.PI

/**
 * Coefficients over those of the dilute elastic gas in first approximation: of spheres by section IV of Garzó & Dufty
 * 1999, Phys. Rev. E 59, 5895, of discs by Lutsko 2005, Phys. Rev. E 72, 021306, who has both.
 *
 * @param dimensions 2 for discs with the contact value of Henderson, 3 for spheres with that of Carnahan & Starling
 */
internal class GranularCoefficients(private val alpha: Double, filling: Double, dimensions: Int) {
    private val d = dimensions.toDouble()
    val chi = if (dimensions == 2) HardDiscs.hendersonContact(filling) else HardSpheres.carnahanStarlingContact(filling)

    /** c* = 2 a₂. */
    val c = 2 * coolingCumulant(alpha, dimensions)

    /** φ χ (1 + α). */
    val close = filling * chi * (1 + alpha)

    /** ζ over the rate n kT/η₀. */
    val cooling = (d + 2) / (4 * d) * chi * (1 - alpha * alpha) * (1 + 3 * c / 32)
    val bulkViscosity = (if (dimensions == 2) 8 / PI else 128 / (5 * PI)) * filling * close * (1 - c / 32)
    val viscosity: Double
        get() {
            // 2^{d−2}/(d + 2)
            val part = (if (d == 2.0) 1 else 2) / (d + 2)
            val relaxation = 3 / (4 * d) * chi * (1 - alpha + 2 * d / 3) * (1 + alpha) * (1 - c / 64)
            val carried = (1 - part * close * (1 - 3 * alpha)) / (relaxation - cooling / 2)
            return carried * (1 + 2 * part * close) + d / (d + 2) * bulkViscosity
        }
}

/** Those of heat, of spheres only. */
internal class GranularConduction(private val alpha: Double, private val filling: Double) {
    private val gas = GranularCoefficients(alpha, filling, 3)
    private val close = gas.close
    private val c = gas.c

    /** d ln χ/d ln φ. */
    private val steepness = 3 * filling / (1 - filling) - filling / (2 - filling)
    private val heatRelaxation = (1 + alpha) / 3 * gas.chi * (1 + 33.0 / 16 * (1 - alpha) + (19 - 3 * alpha) / 1024 * c)
    private val carriedHeat = 2.0 / 3 * (1 + c + 0.6 * close * (1 + alpha) * (2 * alpha - 1 + c * (1 + alpha) / 2)) /
        (heatRelaxation - 2 * gas.cooling)
    val conductivity = carriedHeat * (1 + 1.2 * close) + 256 / (25 * PI) * filling * close * (1 + 7 * c / 32)
    val densityConductivity: Double
        get() {
            // p* (1 + d ln p*/d ln φ), with p* = 1 + 2 (1 + α) φ χ.
            val pressure = 1 + 2 * close * (2 + steepness)
            val lost = alpha * (1 - alpha)
            val carried = (1 + steepness) * gas.cooling * carriedHeat + pressure * c / 3 -
                0.8 * close * (1 + steepness / 2) * (lost + (4.0 / 3 + lost) * c / 4)
            return 2 * carried / (2 * heatRelaxation - 3 * gas.cooling) * (1 + 1.2 * close)
        }
}

/** a₂ of the velocities of a gas that cools, to first order (van Noije & Ernst 1998, Granular Matter 1, 57). */
internal fun coolingCumulant(alpha: Double, dimensions: Int): Double {
    val square = alpha * alpha
    val below = 9 + 24 * dimensions - (41 - 8 * dimensions) * alpha + 30 * square * (1 - alpha)
    return 16 * (1 - alpha) * (1 - 2 * square) / below
}
