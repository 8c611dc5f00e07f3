package daphnis.analysis.transport

import daphnis.analysis.profile.VelocityEllipsoid
import daphnis.analysis.statistics.BlockAverage
import daphnis.core.run.TransportColumns
import daphnis.core.run.TransportColumns.CENTRE_Z
import daphnis.core.run.TransportColumns.COLLISIONS
import daphnis.core.run.TransportColumns.DISSIPATED
import daphnis.core.run.TransportColumns.GRAVITY_XY
import daphnis.core.run.TransportColumns.MASS
import daphnis.core.run.TransportColumns.PARTICLES
import daphnis.core.run.TransportColumns.SCALE_HEIGHT
import daphnis.core.run.TransportColumns.SUM_IMPACT_SPEED
import daphnis.core.run.TransportColumns.TIME
import daphnis.core.run.TransportColumns.WALL_WORK
import daphnis.core.run.TransportColumns.virial
import daphnis.core.space.Space
import daphnis.core.table.Column
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.sqrt

/**
 * Averages of a steady shear flow from a run's [TransportTable]: Hill's frame with γ = dv_y/dx = −(3/2)Ω, or
 * Lees–Edwards boxes. Units are the run's.
 *
 * Rows cut the time into intervals. An interval has the state of the row at its end and what collisions added since the
 * row before. Every quantity is a function of the means of these over all intervals, by length of time, and its error
 * is that of the function ([BlockAverage]): parts that fluctuate together, such as the three pressures, or what
 * particles carry and what collisions carry, are not taken as independent.
 *
 * Two kinds of velocity: c is peculiar, without the mean flow as it is measured, and temperature and dispersion are of
 * it; w is without the straight flow of the boundary's rate, and stresses are of it, since the energy balance holds for
 * it.
 *
 * Formulas (docs/reference/numbers.md has them with their sources): with Σ over particles of mass m, M = Σ m, and over the
 * collisions of a time T,
 *
 * - ν_trans = ⟨w_x w_y⟩ / |γ|, the flux that particles carry by moving (translational, "local");
 * - ν_coll = Σ Δp_y δx / (M T |γ|), the flux that jumps from centre to centre in a collision (collisional, "nonlocal"):
 *   Δp along the flow, δ across it, the part that works against the shear. Surfaces of rough spheres that spin up make
 *   it another number than Σ Δp_x δy;
 * - ν_grav = −½ Σ_ij F_y,ij (x_j − x_i) / (M |γ|), the flux that gravity carries (Daisaka, Tanaka & Ida 2001, Icarus
 *   154, 296);
 * - energy balance γ² (ν_trans + ν_coll + ν_grav) = energy dissipated in a unit of time and mass, in a steady state.
 *
 * (Wisdom & Tremaine 1988, AJ 95, 925.)
 *
 * @param shearRate γ, the change of the flow a unit of length across it; 0 for none
 * @param potential energy of the forces, such as self-gravity, and of spins at each row of [table]; null where it is not
 *   known: then [energyBalance] takes what it gives and takes for scatter
 * @param flowAxis axis of the flow: 0 in Lees–Edwards boxes, 1 in Hill's frame
 * @param space in which particles move: temperature and pressure are those of its components; in the plane what is said
 *   of a volume is of an area
 */
public class Transport @JvmOverloads constructor(
    private val table: TransportTable,
    private val shearRate: Double,
    private val potential: DoubleArray? = null,
    flowAxis: Int = 0,
    private val space: Space = Space.VOLUME,
) {
    init {
        require(potential == null || potential.size == table.size) {
            "there are ${potential?.size} potential energies for ${table.size} rows"
        }
        require(table.size >= 2) {
            val there = if (table.size == 1) "1 row" else "no row"
            "the transport table has $there in the time that is averaged; two are needed"
        }
    }

    private val time = table[TIME]

    /** Of Σ Δp_a δ_b the part along the flow and across it. Without spins, or of an older version, a file has one of both. */
    private val work = virial("yx").takeIf { flowAxis == 1 && it in table } ?: virial("xy")
    private val intervals = table.size - 1
    private val length = DoubleArray(intervals) { time[it + 1] - time[it] }

    /**
     * −1 for a shear that carries momentum to lower velocities along +, as Hill's does; the viscosity is positive
     * either way. NaN without shear.
     */
    private val toViscosity = if (shearRate == 0.0) Double.NaN else -(if (shearRate < 0) -1.0 else 1.0) / abs(shearRate)

    /** Length of time that is averaged. */
    public val duration: Double get() = time.last() - time.first()

    /**
     * False for a file of an older version, whose columns c_ab are around the boundary's straight flow, and with them
     * temperature and dispersion.
     */
    public val isPeculiar: Boolean get() = TransportColumns.kinetic("xx") in table

    /** ⟨c_a c_b⟩ by component name, such as `xx`. */
    public fun moment(component: String): BlockAverage = average(during(TransportColumns.moment(component))) { it[0] }

    /** ⟨w_a w_b⟩ by component name: the kinetic part of the pressure tensor, times volume over mass. */
    public fun kinetic(component: String): BlockAverage = average(during(carried(component))) { it[0] }

    /** √(⟨c_x²⟩ + ⟨c_y²⟩ + ⟨c_z²⟩). */
    public val dispersion: BlockAverage
        get() = average(*diagonal(TransportColumns::moment)) { sqrt(it[0] + it[1] + it[2]) }

    /** √(⟨w_x²⟩ + ⟨w_y²⟩ + ⟨w_z²⟩): of all motion against the boundary's flow, that of waves too. */
    public val totalDispersion: BlockAverage get() = average(*diagonal(::carried)) { sqrt(it[0] + it[1] + it[2]) }

    /** Granular temperature ⟨c²⟩/3, in the plane ⟨c²⟩/2. */
    public val temperature: BlockAverage
        get() = average(*diagonal(TransportColumns::moment)) { (it[0] + it[1] + it[2]) / space.dimensions }

    /** Of the averaged tensor. */
    public val ellipsoid: VelocityEllipsoid
        get() = VelocityEllipsoid.of(moment("xx").mean, moment("yy").mean, moment("zz").mean, moment("xy").mean)

    /**
     * Angle from x to the long axis of the averaged tensor in the plane, toward y, in radians, in (−π/2, π/2]. As shear
     * and rotation turn the components of the tensor into one another, each is in part the change of another.
     */
    public val orientation: BlockAverage
        get() {
            val inPlane = listOf("xx", "yy", "xy").map(TransportColumns::moment)
            val columns = inPlane.map { during(it) }.toTypedArray()
            val whole = ellipsoid.orientation
            // The same axis half a turn on is the same axis: the nearer one is meant.
            val state = inPlane.map { table[it] }.toTypedArray()
            return average(*columns, state = state) { angle(it).let { a -> a - PI * Math.rint((a - whole) / PI) } }
        }

    public val scaleHeight: BlockAverage get() = average(during(SCALE_HEIGHT)) { it[0] }

    /** Collisions of a particle in a unit of time. */
    public val collisionRate: BlockAverage get() = average(added(COLLISIONS, PARTICLES)) { 2 * it[0] }

    /** Mean impact speed. */
    public val impactSpeed: BlockAverage get() = average(added(SUM_IMPACT_SPEED, null), added(COLLISIONS, null)) {
        it[0] / it[1]
    }

    public val translational: BlockAverage get() = kinetic("xy") * toViscosity
    public val collisional: BlockAverage get() = average(added(work, MASS)) { it[0] } * toViscosity
    public val gravitational: BlockAverage get() = average(gravity()) { it[0] } * toViscosity

    /** Sum of the three viscosities. */
    public val viscosity: BlockAverage get() = average(*stresses()) { it[0] + it[1] + it[2] } * toViscosity

    /** The sum of the three viscosities in each interval; they have [viscosity] as their average by length of time. */
    public fun viscosities(): DoubleArray = stresses().let { parts ->
        DoubleArray(intervals) { i -> parts.sumOf { it[i] } / length[i] * toViscosity }
    }

    /** Energy dissipated in a unit of time and mass. */
    public val dissipation: BlockAverage get() = average(added(DISSIPATED, MASS)) { it[0] }

    /**
     * γ² ν over the dissipation: 1 in a steady state. NaN without dissipation. Work less dissipation adds up to the
     * change of the energy from the first row to the last, so the error falls faster than with the root of the time.
     */
    public val energyBalance: BlockAverage
        get() = average(*stresses(), added(DISSIPATED, MASS), state = energies()) {
            if (it[3] == 0.0) Double.NaN else (it[0] + it[1] + it[2]) / it[3]
        } *
            (toViscosity * shearRate * shearRate)

    /**
     * Energy that walls give over what is dissipated: 1 in a steady state; null for a table without the work of walls,
     * NaN without dissipation. Work less dissipation adds up to the change of the energy, so the error is that of this
     * change. There is none where the energy, kinetic or of height, is too slow for one of its own average.
     */
    public val wallBalance: BlockAverage?
        get() {
            if (WALL_WORK !in table) return null
            val kinetic = energies()[0]
            val height = potential?.takeIf { energies -> energies.all { it.isFinite() } } ?: table[CENTRE_Z]
            val found = average(added(WALL_WORK, MASS), added(DISSIPATED, MASS), state = energies() + height) {
                if (it[1] == 0.0) Double.NaN else it[0] / it[1]
            }
            val isKnown = BlockAverage.of(kinetic).isLevelled && BlockAverage.of(height).isLevelled
            return if (isKnown) found else found.withoutError()
        }

    /** Pressure tensor times volume over mass, by component: ⟨w_a w_b⟩ + Σ Δp_a δ_b / (M T). */
    public fun pressure(component: String): BlockAverage =
        average(during(carried(component)), added(virial(component), MASS)) { it[0] + it[1] }

    /** Pressure times volume over mass: a third of the trace of the tensor, in the plane half of it. */
    public val pressure: BlockAverage
        get() = average(*diagonal(::carried), *virials()) { it.sum() / space.dimensions }

    /**
     * [pressure] by component over [pressure]: normal stresses, which add up to the number of dimensions, and the ratio
     * of shear stress to pressure. NaN without pressure.
     */
    public fun pressureRatio(component: String): BlockAverage =
        average(*diagonal(::carried), *virials(), during(carried(component)), added(virial(component), MASS)) {
            (it[PARTS] + it[PARTS + 1]) / (0 until PARTS).sumOf { k -> it[k] } * space.dimensions
        }

    /**
     * Compressibility: pressure over [temperature], the pressure too without the mean flow as it is measured; 1 for
     * points, whatever flows.
     */
    public val compressibility: BlockAverage
        get() = average(*diagonal(TransportColumns::moment), *virials()) { it.sum() / (it[0] + it[1] + it[2]) }

    /** Orbits averaged, for an angular speed. */
    public fun orbits(omega: Double): Double = duration * omega / (2 * PI)

    /** Columns of ⟨w_a w_b⟩. */
    private fun carried(component: String): Column =
        if (isPeculiar) TransportColumns.kinetic(component) else TransportColumns.moment(component)

    private fun angle(m: DoubleArray) = 0.5 * atan2(2 * m[2], m[0] - m[1])

    private fun diagonal(tensor: (String) -> Column) =
        arrayOf(during(tensor("xx")), during(tensor("yy")), during(tensor("zz")))

    private fun virials() = arrayOf(added(virial("xx"), MASS), added(virial("yy"), MASS), added(virial("zz"), MASS))

    private fun stresses() = arrayOf(during(carried("xy")), added(work, MASS), gravity())

    /**
     * By row, what the energy is made of: that of w, that of heights in Hill's frame, half a row's work by which the
     * sum over the ends of intervals differs from the integral, and that of forces.
     */
    private fun energies(): Array<DoubleArray> {
        val (xx, yy, zz) = listOf("xx", "yy", "zz").map { table[carried(it)] }
        val height = table[SCALE_HEIGHT]
        return listOfNotNull(
            DoubleArray(table.size) { xx[it] + yy[it] + zz[it] },
            DoubleArray(table.size) { height[it] * height[it] },
            table[carried("xy")],
            table[GRAVITY_XY],
            potential?.takeIf { energies -> energies.all { it.isFinite() } },
        ).toTypedArray()
    }

    private fun gravity() = table[GRAVITY_XY].let { g ->
        DoubleArray(intervals) { g[it + 1] / table[MASS][it + 1] * length[it] }
    }

    private companion object {
        /** Columns of the trace of the pressure tensor. */
        const val PARTS = 6
    }

    /** The state's [column] times the length of each interval. */
    private fun during(column: Column) = table[column].let { c -> DoubleArray(intervals) { c[it + 1] * length[it] } }

    /** What the running sum [column] gained in each interval, for each of [per]. */
    private fun added(column: Column, per: Column?): DoubleArray {
        val sum = table[column]
        return DoubleArray(intervals) { (sum[it + 1] - sum[it]) / if (per == null) 1.0 else table[per][it] }
    }

    /** [function] of the sums of [columns] over the sum of lengths; they in part sum changes of the [state]. */
    private fun average(
        vararg columns: DoubleArray,
        state: Array<DoubleArray> = emptyArray(),
        function: (DoubleArray) -> Double,
    ): BlockAverage {
        val rates = DoubleArray(columns.size)
        return BlockAverage.of(arrayOf(*columns, length), state) { means ->
            for (k in rates.indices) rates[k] = means[k] / means[rates.size]
            function(rates)
        }
    }
}
