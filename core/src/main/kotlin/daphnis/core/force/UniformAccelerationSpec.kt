package daphnis.core.force

import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.population.Population
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** See [UniformAcceleration]. */
@Serializable
@SerialName("uniform-acceleration")
@Described("the same acceleration for every sphere")
public class UniformAccelerationSpec(
    @Described("three numbers, length/time²")
    override val acceleration: List<Double>,
) : ForceSpec {
    override val allowsChangingBox: Boolean get() = true
    override val actsOnDiscs: Boolean get() = true
    override val heats: Boolean get() = false

    override fun force(place: ForcePlace): Force {
        val key = "${place.key}.acceleration"
        place.check.that(key, acceleration, acceleration.size == 3) { "must be three numbers" }
        place.check.inSpace(key, acceleration, place.boundary.space)
        return UniformAcceleration(acceleration[0], acceleration[1], acceleration[2])
    }

    override fun inWords(place: ForcePlace, population: Population, say: Quantities): String =
        "uniform-acceleration, ${acceleration.joinToString { say.acceleration(it) }}"
}
