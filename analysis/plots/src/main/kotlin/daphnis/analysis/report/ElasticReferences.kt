package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.analysis.theory.EnskogGas
import daphnis.analysis.theory.HardDiscs
import daphnis.analysis.theory.HardSphereMixture
import daphnis.analysis.theory.HardSpheres
import daphnis.core.population.Population
import daphnis.core.scenario.LatticeName
import daphnis.core.scenario.Scenario
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.math.sqrt

/**
 * What theory knows of elastic gases at rest in periodic boxes: collision rate, compressibility and coefficients of
 * transport, by [NumberRow.key]. Each has its formula's own accuracy as its bound, and is given in its range only.
 */
internal object ElasticReferences {
    /** Most kinds of spheres for which pairs of kinds are summed. */
    private const val MOST_KINDS = 64

    /** Of Enskog's coefficients up to [EnskogGas.MOST_FILLED], relative; of the equation of mixtures. */
    private const val ENSKOG_BOUND = 0.1
    private const val BULK_BOUND = 0.3
    private const val MIXTURE_BOUND = 0.005

    /** Of N spheres pressure is lower, relatively by up to this over N at a filling factor of 0.3. */
    private const val FEW = 0.9
    private const val LUDING_BOUND = 6e-3

    /** Of the first correction for few spheres, what the next ones may be. */
    private const val BEYOND_FIRST = 0.3
    private const val MOST_LUDING = 0.65
    private const val KOLAFA = "Kolafa, Labík & Malijevský 2004"
    private const val SPEEDY = "Speedy 1998"
    private const val LUDING = "Luding 2001"
    private const val MIXTURE = "BMCSL, Mansoori et al. 1971"
    private const val ENSKOG = "Enskog, Chapman & Cowling 1970"

    /** @param temperature ⟨c²⟩/3 or, of discs, ⟨c²⟩/2 */
    fun of(scenario: Scenario, last: State, filling: Double, temperature: Double, density: Double) = when {
        !ElasticGas.isAtRest(scenario, last) -> emptyMap()
        last.dimensions == 2 ->
            if (ElasticGas.isSeen(
                    scenario,
                    last,
                )
            ) {
                ofDiscs(last.population, filling, temperature, density)
            } else {
                emptyMap()
            }
        !ElasticGas.isSeen(scenario, last) -> ofMixture(last.population, temperature, density)
        filling <= HardSpheres.FREEZING -> ofFluid(last.population, filling, temperature)
        filling >= HardSpheres.MELTING && isCrystal(scenario) -> ofCrystal(last.population, filling, temperature)
        else -> emptyMap()
    }

    private fun isCrystal(scenario: Scenario) =
        scenario.placement.let { it.lattice == LatticeName.FCC && it.vacancies == 0.0 }

    private fun ofFluid(p: Population, filling: Double, temperature: Double): Map<String, Reference> {
        val z = HardSpheres.kolafaLabikMalijevsky(filling, p.size)
        val few = z - HardSpheres.kolafaLabikMalijevsky(filling)
        val bound = hypot(HardSpheres.KOLAFA_LABIK_MALIJEVSKY_ACCURACY * z, BEYOND_FIRST * few)
        return ofSpheres(p, filling, temperature, z, bound, KOLAFA) + ofTransport(p, filling, temperature)
    }

    private fun ofCrystal(p: Population, filling: Double, temperature: Double): Map<String, Reference> {
        // N spheres have N − 1 free volumes.
        val z = HardSpheres.speedy(filling) * (1 - 1.0 / p.size)
        return ofSpheres(p, filling, temperature, z, HardSpheres.SPEEDY_ACCURACY * z, SPEEDY)
    }

    /**
     * The rate follows from the contact value in [z]. That of N − 1 free spheres is 1/12N faster: ⟨c⟩ at one energy.
     */
    private fun ofSpheres(
        p: Population,
        filling: Double,
        temperature: Double,
        z: Double,
        bound: Double,
        source: String,
    ): Map<String, Reference> {
        val rate = 6 * sqrt(temperature / PI) * (z - 1) / (2 * p.radius[0]) * (1 + 1.0 / (12 * p.size))
        return mapOf(
            "collisions_per_particle" to Reference(rate, rate * bound / (z - 1), source),
            "compressibility" to Reference(z, bound, source),
        )
    }

    private fun ofTransport(p: Population, filling: Double, temperature: Double): Map<String, Reference> {
        if (filling > EnskogGas.MOST_FILLED) return emptyMap()
        val diameter = 2 * p.radius[0]
        val mass = p.mass[0]
        val thermal = mass * temperature
        fun enskog(value: Double, bound: Double) = Reference(value, bound * value, ENSKOG)
        return mapOf(
            "viscosity_helfand" to enskog(EnskogGas.viscosity(diameter, mass, filling, thermal), ENSKOG_BOUND),
            "bulk_viscosity_helfand" to enskog(EnskogGas.bulkViscosity(diameter, mass, filling, thermal), BULK_BOUND),
            "conductivity_helfand" to enskog(EnskogGas.conductivity(diameter, mass, filling, thermal), ENSKOG_BOUND),
        )
    }

    /** Of discs; what few of them have is some 1/N less. */
    private fun ofDiscs(p: Population, filling: Double, temperature: Double, density: Double): Map<String, Reference> {
        if (filling > MOST_LUDING) return emptyMap()
        val z = HardDiscs.luding(filling)
        val contact = (z - 1) / (2 * filling)
        val rate = 2 * sqrt(PI * temperature) * density * contact * 2 * p.radius[0]
        val bound = hypot(LUDING_BOUND * z, 3 * z / p.size)
        return mapOf(
            "collisions_per_particle" to Reference(rate, bound / (z - 1) * rate, "Enskog, χ of $LUDING"),
            "compressibility" to Reference(z, bound, LUDING),
        )
    }

    private fun ofMixture(p: Population, temperature: Double, density: Double): Map<String, Reference> {
        val kinds = (0 until p.size).groupingBy { p.radius[it] to p.mass[it] }.eachCount().entries.toList()
        val share = DoubleArray(kinds.size) { density * kinds[it].value / p.size }
        val mixture = HardSphereMixture(DoubleArray(kinds.size) { 2 * kinds[it].key.first }, share)
        if (mixture.filling > HardSpheres.FREEZING) return emptyMap()
        val z = mixture.compressibility
        val pressure = mapOf("compressibility" to Reference(z, hypot(MIXTURE_BOUND, FEW / p.size) * z, MIXTURE))
        if (kinds.size > MOST_KINDS) return pressure
        val thermal = temperature * p.mass.average()
        var rate = 0.0
        for (i in kinds.indices) {
            for (j in kinds.indices) {
                val (m1, m2) = kinds[i].key.second to kinds[j].key.second
                val reach = kinds[i].key.first + kinds[j].key.first
                val speed = sqrt(8 * PI * thermal * (m1 + m2) / (m1 * m2))
                rate += share[i] / density * share[j] * reach * reach * speed * mixture.contactValue(i, j)
            }
        }
        val bound = hypot(MIXTURE_BOUND, FEW / p.size) * z / abs(z - 1)
        return pressure + ("collisions_per_particle" to Reference(rate, bound * rate, "Enskog, χ of $MIXTURE"))
    }
}
