package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import daphnis.analysis.profile.Profile
import daphnis.analysis.profile.VelocityEllipsoid
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.transport.Transport
import daphnis.core.population.VelocityMoments
import daphnis.core.scenario.ForceSpec
import kotlin.math.PI

/**
 * The table of numbers of a run: from its transport file where there is one, else from its snapshots; beside known
 * values where there are any.
 */
internal class Numbers(private val input: AnalysisInput, private val from: Double, private val states: Averages) {
    private val units = input.units
    private val state = input.state(input.size - 1)
    private val population = state.population
    private val transport = input.transport?.from(from)?.takeIf { it.size >= 2 }?.let {
        Transport(
            it,
            state.boundary.meanFlow?.rate ?: 0.0,
        )
    }

    val meanRadius: Double = indices().map { population.radius[it] }.average()
    val opticalDepth: Double = indices().sumOf { PI * population.radius[it] * population.radius[it] } / state.area
    val surfaceDensity: Double = indices().sumOf { population.mass[it] } / state.area
    private val fillingFactor =
        indices().sumOf { 4.0 / 3 * PI * population.radius[it] * population.radius[it] * population.radius[it] } /
            state.boundary.box.volume

    /** G of the run's self-gravity; null without. */
    private val selfGravity: Double? = input.scenario?.forces?.filterIsInstance<ForceSpec.SelfGravity>()?.firstOrNull()
        ?.let { it.constant ?: input.scenario.units.gravitationalConstant }

    /** Toomre's 4π² G Σ/Ω²; NaN without self-gravity. */
    val criticalWavelength: Double =
        input.omega?.let { 4 * PI * PI * (selfGravity ?: Double.NaN) * surfaceDensity / (it * it) } ?: Double.NaN

    /** Whether averages are over the rows of the transport file; else they are over states alone. */
    val isFromTransport: Boolean get() = transport != null

    private fun indices() = (0 until population.size).filter { state.isParticle(it) }

    /** ⟨c_a c_b⟩: xx, yy, zz, xy; from the transport file, else from the snapshots. */
    private fun moment(name: String): BlockAverage =
        transport?.moment(name) ?: states.average(VelocityMoments.COMPONENTS.indexOf(name))

    val ellipsoid: VelocityEllipsoid get() = VelocityEllipsoid.of(
        moment("xx").mean,
        moment("yy").mean,
        moment("zz").mean,
        moment("xy").mean,
    )

    /** Whether the averages are over a steady time, in sentences. */
    fun steadiness(): List<String> {
        val histories = RunHistory.of(input, from).ifEmpty {
            listOf(History("granular temperature", DoubleArray(states.size) { from + it }, states.series(TEMPERATURE)))
        }
        val orbit = input.omega?.let { 2 * PI / it }
        return SteadinessText(from, if (orbit != null) "orbit" else "unit of time", orbit ?: 1.0).of(histories)
    }

    fun rows(): List<NumberRow> = if (input.omega != null) ring(input.omega) else box()

    private fun ring(omega: Double): List<NumberRow> {
        val r = meanRadius
        val speed = r * omega
        val references = input.scenario?.let { References.ofPatch(it, omega, opticalDepth) } ?: emptyMap()
        val rows = ArrayList<NumberRow>()
        fun add(what: String, a: BlockAverage, unit: String, scale: Double, key: String = "", note: String = "") {
            rows += NumberRow.of(what, a * (1 / scale), unit, references[key], note)
        }
        fun exact(what: String, value: Double, unit: String, note: String = "") {
            rows += NumberRow(what, value, Double.NaN, unit, note = note)
        }
        exact("optical depth τ", opticalDepth, "", "Σ π r² over the area")
        exact("surface density Σ", surfaceDensity, units.surfaceDensity)
        exact("mean radius r", r, units.length)
        exact("r Ω", speed, units.speed)
        add("velocity dispersion c", transport?.dispersion ?: states.average(DISPERSION), "r Ω", speed, "c")
        for ((name, axis) in listOf(
            "xx" to "x",
            "yy" to "y",
            "zz" to "z",
        )) {
            add("σ_$axis", moment(name).root(), "r Ω", speed, "sigma_$axis")
        }
        val orientation = transport?.orientation ?: BlockAverage(ellipsoid.orientation, Double.NaN, states.size)
        add(
            "orientation of the velocity ellipsoid",
            orientation,
            "degrees",
            Math.toRadians(1.0),
            note = "from the radial direction toward the orbit",
        )
        add("scale height H", transport?.scaleHeight ?: states.average(HEIGHT), "r", r, "H")
        add("filling factor in the middle plane", states.average(MIDPLANE), "", 1.0, "midplane")
        if (transport != null) {
            add("collisions of a particle", transport.collisionRate, "1/orbit", omega / (2 * PI), "collisions")
            add(
                "mean impact speed",
                transport.impactSpeed,
                "cm/s",
                1 / (input.scenario?.units?.speedInCmPerSecond ?: 1.0),
            )
            val unit = r * r * omega
            add("viscosity, translational", transport.translational, "r² Ω", unit, "nu_trans")
            add("viscosity, collisional", transport.collisional, "r² Ω", unit, "nu_coll")
            if (transport.gravitational.mean != 0.0) {
                add("viscosity, gravitational", transport.gravitational, "r² Ω", unit)
            }
            add("viscosity, total", transport.viscosity, "r² Ω", unit)
            add("viscosity, total, in the run's units", transport.viscosity, units.viscosity, 1.0)
            add("(9/4) Ω² ν over dissipation", transport.energyBalance, "", 1.0, note = "1 in a steady state")
        }
        val constant = selfGravity
        if (constant != null) {
            val dispersion = moment("xx").root()
            add("Toomre's Q", dispersion, "", 3.36 * constant * surfaceDensity / omega, note = "σ_x Ω / (3.36 G Σ)")
            exact("critical wavelength 4π² G Σ/Ω²", criticalWavelength, units.length)
        }
        return rows
    }

    private fun box(): List<NumberRow> {
        val rows = ArrayList<NumberRow>()
        val scenario = input.scenario
        val density = indices().size / state.boundary.box.volume
        val temperature = transport?.temperature ?: states.average(TEMPERATURE)
        rows += NumberRow("filling factor φ", fillingFactor, Double.NaN, "")
        rows += NumberRow("mean radius", meanRadius, Double.NaN, units.length)
        val gas = scenario?.let { References.ofElastic(it, fillingFactor, temperature.mean, density) } ?: emptyMap()
        val isOld = state.boundary.meanFlow != null && transport?.isPeculiar == false
        val note = if (isOld) OLD_TRANSPORT else ""
        rows += NumberRow.of("granular temperature ⟨c²⟩/3", temperature, units.temperature, note = note)
        if (transport == null) return rows
        rows += NumberRow.of("collisions of a particle", transport.collisionRate, units.rate, gas["rate"])
        rows += NumberRow.of("compressibility p V / (M T)", transport.compressibility, "", gas["Z"])
        val flow = state.boundary.meanFlow
        return if (flow == null || flow.rate == 0.0) rows else rows + sheared(transport, flow.rate)
    }

    /** T/(γσ)², stresses over ρ_p σ²γ² with ρ_p the mass of a sphere over its volume. */
    private fun sheared(transport: Transport, rate: Double): List<NumberRow> {
        val rows = ArrayList<NumberRow>()
        val shear = input.scenario?.let { References.ofShear(it, fillingFactor) } ?: emptyMap()
        val mass = population.mass.sum()
        val diameter = 2 * meanRadius
        val gamma2 = rate * rate * diameter * diameter
        val stress =
            mass / state.boundary.box.volume /
                (population.mass.average() / (PI / 6 * diameter * diameter * diameter) * gamma2)
        rows += NumberRow.of("temperature T* = T/(γσ)²", transport.temperature * (1 / gamma2), "", shear["T*"])
        rows += NumberRow.of("pressure p* = p/(ρ_p σ²γ²)", transport.pressure * stress, "", shear["p*"])
        rows +=
            NumberRow.of(
                "shear stress τ* = −P_xy/(ρ_p σ²γ²)",
                transport.pressure("xy") * (-stress * Math.signum(rate)),
                "",
                shear["tau*"],
            )
        rows += NumberRow.of("viscosity, translational", transport.translational, units.viscosity)
        rows += NumberRow.of("viscosity, collisional", transport.collisional, units.viscosity)
        rows += NumberRow.of("viscosity, total", transport.viscosity, units.viscosity)
        rows += NumberRow.of("γ² ν over dissipation", transport.energyBalance, "", note = "1 in a steady state")
        return rows
    }

    companion object {
        private const val DISPERSION = 6
        private const val HEIGHT = 7
        private const val TEMPERATURE = 8
        private const val MIDPLANE = 9
        private const val OLD_TRANSPORT = "around the boundary's straight flow: transport.csv is of an older version"

        /** Moments, dispersion, scale height, temperature, filling factor in the middle plane of one state. */
        val OF_STATE: Measure = Measure { state: State ->
            val m = VelocityMoments.of(state.population, state.boundary.meanFlow, state.omega, state.firstBody)
            val radius = state.population.radius.minOrNull() ?: 1.0
            val slab = Profile(2, m.centreZ - radius / 10, m.centreZ + radius / 10, 1).of(state)
            val filling = slab[Profile.COLUMNS.indexOf("filling_factor")]
            m.moments + doubleArrayOf(m.dispersion, m.scaleHeight, m.temperature, filling)
        }
    }
}
