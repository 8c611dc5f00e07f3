package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.State
import kotlin.math.PI

/** How many and how large the particles of a [state] are, and what follows from that alone. Bodies are left out. */
internal class Bulk(state: State, input: AnalysisInput) {
    private val population = state.population
    private val indices = (0 until population.size).filter { state.isParticle(it) }
    private val space = state.boundary.space
    private val area = state.meanArea
    private val volume = state.boundary.volume * (area / state.area)

    val particles: Int = indices.size

    /** NaN without particles. */
    val meanRadius: Double = indices.map { population.radius[it] }.average()

    /** The mean radius, or 1 without particles: something to choose bins by. */
    val typicalRadius: Double = if (meanRadius.isNaN()) 1.0 else meanRadius

    /** What to say of averages over particles that are weighted by mass; nothing of particles of one mass. */
    val byMass: String = if (indices.any { population.mass[it] != population.mass[indices[0]] }) ", by mass" else ""
    val largestRadius: Double = indices.maxOfOrNull { population.radius[it] } ?: 1.0

    /** Diameter of the smallest, 0 without particles. */
    val nearestContact: Double = indices.minOfOrNull { 2 * population.radius[it] } ?: 0.0

    val opticalDepth: Double = indices.sumOf { PI * population.radius[it] * population.radius[it] } / area
    val surfaceDensity: Double = indices.sumOf { population.mass[it] } / area

    /** Of discs the area fraction. */
    val fillingFactor: Double = indices.sumOf { space.volume(population.radius[it]) } / volume
    val numberDensity: Double = particles / volume

    /** G of the run's self-gravity; null without. */
    val selfGravity: Double? = input.scenario?.selfGravity

    /** Toomre's 4π² G Σ/κ²; NaN without self-gravity. */
    val criticalWavelength: Double =
        input.frequencies?.kappa?.let { 4 * PI * PI * (selfGravity ?: Double.NaN) * surfaceDensity / (it * it) }
            ?: Double.NaN

    /**
     * Hill radius of two particles of the mean mass, over the distance of their centres in contact; NaN without
     * self-gravity.
     */
    val hillRatio: Double = input.frequencies?.omega?.let { omega ->
        val mass = indices.map { population.mass[it] }.average()
        val radius = Math.cbrt(indices.map { population.radius[it].let { r -> r * r * r } }.average())
        Math.cbrt(2 * (selfGravity ?: Double.NaN) * mass / (3 * omega * omega)) / (2 * radius)
    } ?: Double.NaN

    /**
     * 26 r_h⁵ G² Σ²/Ω³ (Daisaka, Tanaka & Ida 2001, Icarus 154, 296), the total viscosity of wakes; NaN without
     * self-gravity.
     */
    val viscosityOfWakes: Double = input.frequencies?.omega?.let { omega ->
        val pull = (selfGravity ?: Double.NaN) * surfaceDensity
        26 * Math.pow(hillRatio, 5.0) * pull * pull / (omega * omega * omega)
    } ?: Double.NaN
}
