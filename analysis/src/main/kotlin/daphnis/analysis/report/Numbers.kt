package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PatchState
import daphnis.analysis.profile.Profile
import daphnis.analysis.profile.VelocityEllipsoid
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.transport.Transport
import daphnis.core.population.VelocityMoments
import kotlin.math.PI
import kotlin.math.sqrt

/** The table of numbers of a run: from its transport file where there is one, else from its snapshots; beside known values where there are any. */
internal class Numbers(private val input: AnalysisInput, private val from: Double, private val states: Averages) {
    private val units = input.units
    private val state = input.state(input.size - 1)
    private val population = state.population
    private val transport = input.transport?.from(from)?.takeIf { it.size >= 2 }?.let { Transport(it, state.boundary.meanFlow?.rate ?: 0.0) }

    val meanRadius: Double = indices().map { population.radius[it] }.average()
    val opticalDepth: Double = indices().sumOf { PI * population.radius[it] * population.radius[it] } / state.area
    val surfaceDensity: Double = indices().sumOf { population.mass[it] } / state.area
    private val fillingFactor = indices().sumOf { 4.0 / 3 * PI * population.radius[it] * population.radius[it] * population.radius[it] } / state.boundary.box.volume

    /** Whether averages are over the rows of the transport file; else they are over states alone. */
    val isFromTransport: Boolean get() = transport != null

    private fun indices() = (0 until population.size).filter { state.isParticle(it) }

    /** ⟨c_a c_b⟩: xx, yy, zz, xy; from the transport file, else from the snapshots. */
    private fun moment(name: String): BlockAverage = transport?.moment(name) ?: states.average(VelocityMoments.COMPONENTS.indexOf(name))

    val ellipsoid: VelocityEllipsoid get() = VelocityEllipsoid.of(moment("xx").mean, moment("yy").mean, moment("zz").mean, moment("xy").mean)

    fun rows(): List<NumberRow> = if (input.omega != null) ring(input.omega) else box()

    private fun ring(omega: Double): List<NumberRow> {
        val r = meanRadius
        val speed = r * omega
        val references = input.scenario?.let { References.ofPatch(it, omega, opticalDepth) } ?: emptyMap()
        val rows = ArrayList<NumberRow>()
        fun add(what: String, a: BlockAverage, unit: String, scale: Double, key: String = "", note: String = "") {
            rows += NumberRow(what, a.mean / scale, a.error / scale, unit, references[key], note)
        }
        fun exact(what: String, value: Double, unit: String, note: String = "") {
            rows += NumberRow(what, value, Double.NaN, unit, note = note)
        }
        exact("optical depth τ", opticalDepth, "", "Σ π r² over the area")
        exact("surface density Σ", surfaceDensity, units.surfaceDensity)
        exact("mean radius r", r, units.length)
        exact("r Ω", speed, units.speed)
        add("velocity dispersion c", transport?.dispersion ?: states.average(DISPERSION), "r Ω", speed, "c")
        for ((name, axis) in listOf("xx" to "x", "yy" to "y", "zz" to "z")) add("σ_$axis", root(moment(name)), "r Ω", speed, "sigma_$axis")
        exact("orientation of the velocity ellipsoid", Math.toDegrees(ellipsoid.orientation), "degrees", "from the radial direction toward the orbit")
        add("scale height H", transport?.scaleHeight ?: states.average(HEIGHT), "r", r, "H")
        add("filling factor in the middle plane", states.average(MIDPLANE), "", 1.0, "midplane")
        if (transport != null) {
            add("collisions of a particle", transport.collisionRate, "1/orbit", omega / (2 * PI), "collisions")
            exact("mean impact speed", transport.impactSpeed * (input.scenario?.units?.speedInCmPerSecond ?: 1.0), "cm/s")
            val unit = r * r * omega
            add("viscosity, translational", transport.translational, "r² Ω", unit, "nu_trans")
            add("viscosity, collisional", transport.collisional, "r² Ω", unit, "nu_coll")
            if (transport.gravitational.mean != 0.0) add("viscosity, gravitational", transport.gravitational, "r² Ω", unit)
            exact("viscosity, total", transport.viscosity, units.viscosity)
            exact("(9/4) Ω² ν over dissipation", transport.energyBalance, "", "1 in a steady state")
        }
        val gravity = input.scenario?.forces?.filterIsInstance<daphnis.core.scenario.ForceSpec.SelfGravity>()?.firstOrNull()
        val constant = gravity?.constant ?: input.scenario?.units?.gravitationalConstant
        if (gravity != null && constant != null) {
            val dispersion = root(moment("xx"))
            add("Toomre's Q", dispersion, "", 3.36 * constant * surfaceDensity / omega, note = "σ_x Ω / (3.36 G Σ)")
            exact("critical wavelength 4π² G Σ/Ω²", 4 * PI * PI * constant * surfaceDensity / (omega * omega), units.length)
        }
        return rows
    }

    private fun box(): List<NumberRow> {
        val rows = ArrayList<NumberRow>()
        val scenario = input.scenario
        val n = indices().size
        val density = n / state.boundary.box.volume
        val temperature = transport?.temperature ?: states.average(TEMPERATURE)
        rows += NumberRow("filling factor φ", fillingFactor, Double.NaN, "")
        rows += NumberRow("mean radius", meanRadius, Double.NaN, units.length)
        val flow = state.boundary.meanFlow
        val gas = scenario?.let { References.ofElastic(it, fillingFactor, temperature.mean, density) } ?: emptyMap()
        rows += NumberRow("granular temperature ⟨c²⟩/3", temperature.mean, temperature.error, units.temperature)
        if (transport == null) return rows
        val mass = population.mass.sum()
        val rate = transport.collisionRate
        rows += NumberRow("collisions of a particle", rate.mean, rate.error, units.rate, gas["rate"])
        val pressure = listOf("xx", "yy", "zz").map { transport.pressure(it) }
        val p = BlockAverage(pressure.sumOf { it.mean } / 3, sqrt(pressure.sumOf { it.error * it.error }) / 3, pressure[0].count)
        rows += NumberRow("compressibility p V / (M T)", p.mean / temperature.mean, p.error / temperature.mean, "", gas["Z"])
        if (flow == null || flow.rate == 0.0) return rows
        val shear = scenario?.let { References.ofShear(it, fillingFactor) } ?: emptyMap()
        // T/(γσ)², stresses over ρ_p σ²γ² with ρ_p the mass of a sphere over its volume.
        val diameter = 2 * meanRadius
        val gamma2 = flow.rate * flow.rate * diameter * diameter
        val stress = mass / state.boundary.box.volume / (population.mass.average() / (PI / 6 * diameter * diameter * diameter) * gamma2)
        rows += NumberRow("temperature T* = T/(γσ)²", temperature.mean / gamma2, temperature.error / gamma2, "", shear["T*"])
        rows += NumberRow("pressure p* = p/(ρ_p σ²γ²)", p.mean * stress, p.error * stress, "", shear["p*"])
        val xy = transport.pressure("xy")
        rows += NumberRow("shear stress τ* = −P_xy/(ρ_p σ²γ²)", -xy.mean * stress * Math.signum(flow.rate), xy.error * stress, "", shear["tau*"])
        rows += NumberRow("viscosity, translational", transport.translational.mean, transport.translational.error, units.viscosity)
        rows += NumberRow("viscosity, collisional", transport.collisional.mean, transport.collisional.error, units.viscosity)
        rows += NumberRow("γ² ν over dissipation", transport.energyBalance, Double.NaN, "", note = "1 in a steady state")
        return rows
    }

    private fun root(a: BlockAverage) = BlockAverage(sqrt(a.mean), a.error / (2 * sqrt(a.mean)), a.count)

    companion object {
        private const val DISPERSION = 6
        private const val HEIGHT = 7
        private const val TEMPERATURE = 8
        private const val MIDPLANE = 9

        /** Moments, dispersion, scale height, temperature, filling factor in the middle plane of one state. */
        val OF_STATE: Measure = Measure { state: PatchState ->
            val m = VelocityMoments.of(state.population, state.boundary.meanFlow, state.omega, state.particles)
            val radius = state.population.radius.minOrNull() ?: 1.0
            val slab = Profile(2, m.centreZ - radius / 10, m.centreZ + radius / 10, 1).of(state)
            m.moments + doubleArrayOf(m.dispersion, m.scaleHeight, (m.moments[0] + m.moments[1] + m.moments[2]) / 3, slab[Profile.COLUMNS.indexOf("filling_factor")])
        }
    }
}
