package daphnis.core.force

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.population.Population
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/**
 * Gravity of the scenario's bodies on all other spheres and, as reaction, of these on the bodies, but not among the
 * other spheres. Nearest images count. See [BodyGravity].
 */
@Serializable
@SerialName("body-gravity")
@Described("gravity between `bodies` and all other spheres, but not among those others")
public class BodyGravitySpec @JvmOverloads constructor(
    @Described("ε in 1/(r² + ε²), a length; default 0")
    public val softening: Double = 0.0,
    @Described("G in the scenario's units; default from `units.lengthInMetres`")
    override val constant: Double? = null,
) : ForceSpec {
    override fun force(place: ForcePlace): Force {
        place.check.must(place.key, place.bodies > 0) { "is body-gravity; it needs bodies" }
        place.check.atLeast0("${place.key}.softening", softening)
        val ids = IntArray(place.bodies) { place.firstBody + it }
        return BodyGravity(ids, place.boundary, place.constant(constant), softening)
    }

    override fun inWords(place: ForcePlace, population: Population, say: Quantities): String =
        "body-gravity, softening ${say.length(softening)}"

    override fun fastestPull(place: ForcePlace, population: Population): Pull? {
        val g = constant ?: place.units.gravitationalConstant ?: return null
        val smallest = place.particles(population).minOfOrNull { population.radius[it] } ?: return null
        val fastest = (0 until population.size).filter { place.isBody(population.id[it]) }.maxOfOrNull {
            orbitalRate(g * population.mass[it], population.radius[it] + smallest, softening)
        }
        return fastest?.let { Pull(it, "an orbit on the surface of a body") }
    }
}
