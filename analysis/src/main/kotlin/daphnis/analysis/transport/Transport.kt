package daphnis.analysis.transport

import daphnis.analysis.profile.VelocityEllipsoid
import daphnis.analysis.statistics.BlockAverage
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Averages of a steady shear flow from a run's [TransportTable]: Hill's frame with γ = dv_y/dx = −(3/2)Ω, or
 * Lees–Edwards boxes. Errors are standard errors from block averaging. Units are the run's.
 *
 * Two kinds of velocity: c is peculiar, without the mean flow as it is measured, and temperature and dispersion are of
 * it; w is without the straight flow of the boundary's rate, and stresses are of it, since the energy balance holds for
 * it.
 *
 * Formulas (docs/analysis.md has them with their sources): with Σ over particles of mass m, M = Σ m, and over the
 * collisions of a time T,
 *
 * - ν_trans = ⟨w_x w_y⟩ / |γ|, the flux that particles carry by moving (translational, "local");
 * - ν_coll = Σ Δp_y δx / (M T |γ|), the flux that jumps from centre to centre in a collision (collisional, "nonlocal");
 * - ν_grav = −½ Σ_ij F_y,ij (x_j − x_i) / (M |γ|), the flux that gravity carries (Daisaka, Tanaka & Ida 2001, Icarus
 *   154, 296);
 * - energy balance γ² (ν_trans + ν_coll + ν_grav) = energy dissipated in a unit of time and mass, in a steady state.
 *
 * (Wisdom & Tremaine 1988, AJ 95, 925.)
 *
 * @param shearRate γ, the change of the flow a unit of length across it; 0 for none
 */
public class Transport(private val table: TransportTable, private val shearRate: Double) {
    init {
        require(table.size >= 2) { "the transport table has ${table.size} rows in the time that is averaged; two are needed" }
    }

    private val time = table["time"]

    /** Length of time that is averaged. */
    public val duration: Double get() = time.last() - time.first()

    /**
     * False for a file of an older version, whose columns c_ab are around the boundary's straight flow, and with them
     * temperature and dispersion.
     */
    public val isPeculiar: Boolean get() = "kinetic_xx" in table

    /** ⟨c_a c_b⟩ by component name, such as `xx`. */
    public fun moment(component: String): BlockAverage = BlockAverage.of(table["c_$component"])

    /** ⟨w_a w_b⟩ by component name: the kinetic part of the pressure tensor, times volume over mass. */
    public fun kinetic(component: String): BlockAverage = BlockAverage.of(table[if (isPeculiar) "kinetic_$component" else "c_$component"])

    /** √(⟨c_x²⟩ + ⟨c_y²⟩ + ⟨c_z²⟩). */
    public val dispersion: BlockAverage
        get() = BlockAverage.of(DoubleArray(table.size) { sqrt(table["c_xx"][it] + table["c_yy"][it] + table["c_zz"][it]) })

    /** Granular temperature ⟨c²⟩/3. */
    public val temperature: BlockAverage
        get() = BlockAverage.of(DoubleArray(table.size) { (table["c_xx"][it] + table["c_yy"][it] + table["c_zz"][it]) / 3 })

    /** Of the averaged tensor. */
    public val ellipsoid: VelocityEllipsoid
        get() = VelocityEllipsoid.of(moment("xx").mean, moment("yy").mean, moment("zz").mean, moment("xy").mean)

    public val scaleHeight: BlockAverage get() = BlockAverage.of(table["scale_height"])

    /** Collisions of a particle in a unit of time. */
    public val collisionRate: BlockAverage get() = rate("collisions") { 2.0 / table["particles"][it] }

    /** Mean impact speed. */
    public val impactSpeed: Double
        get() = (table["sum_impact_speed"].last() - table["sum_impact_speed"].first()) / (table["collisions"].last() - table["collisions"].first())

    public val translational: BlockAverage get() = scaled(kinetic("xy"), -sign() / rateOrNaN())
    public val collisional: BlockAverage get() = rate("virial_xy") { -sign() / table["mass"][it] / rateOrNaN() }
    public val gravitational: BlockAverage
        get() = BlockAverage.of(DoubleArray(table.size) { -sign() * table["gravity_xy"][it] / table["mass"][it] / rateOrNaN() })

    /** Sum of the three viscosities; the error of the sum of series, since they are correlated. */
    public val viscosity: Double get() = translational.mean + collisional.mean + gravitational.mean

    /** Energy dissipated in a unit of time and mass. */
    public val dissipation: BlockAverage get() = rate("dissipated") { 1 / table["mass"][it] }

    /** γ² ν over the dissipation: 1 in a steady state. NaN without dissipation. */
    public val energyBalance: Double get() = shearRate * shearRate * viscosity / dissipation.mean

    /** Pressure tensor times volume over mass, by component: ⟨w_a w_b⟩ + Σ Δp_a δ_b / (M T). */
    public fun pressure(component: String): BlockAverage {
        val collisions = rate("virial_$component") { 1 / table["mass"][it] }
        val kinetic = kinetic(component)
        val error = sqrt(kinetic.error * kinetic.error + collisions.error * collisions.error)
        return BlockAverage(kinetic.mean + collisions.mean, error, kinetic.count)
    }

    /** Orbits averaged, for an angular speed. */
    public fun orbits(omega: Double): Double = duration * omega / (2 * PI)

    /** −1 for a shear that carries momentum to lower velocities along +, as Hill's does; the viscosity is positive either way. */
    private fun sign() = if (shearRate < 0) -1.0 else 1.0

    private fun rateOrNaN() = if (shearRate == 0.0) Double.NaN else abs(shearRate)

    private fun scaled(a: BlockAverage, factor: Double) = BlockAverage(a.mean * factor, a.error * abs(factor), a.count)

    /** Average rate of the running sum [column]: from the ends, its error from what was added between rows. */
    private inline fun rate(column: String, factor: (Int) -> Double): BlockAverage {
        val sum = table[column]
        val rates = DoubleArray(table.size - 1) { (sum[it + 1] - sum[it]) / (time[it + 1] - time[it]) * factor(it) }
        return BlockAverage.of(rates)
    }
}
