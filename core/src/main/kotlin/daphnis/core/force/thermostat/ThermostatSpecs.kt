package daphnis.core.force.thermostat

import daphnis.core.force.Force
import daphnis.core.force.ForcePlace
import daphnis.core.force.ForceSpec
import daphnis.core.force.WhiteHeating
import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.population.Population
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/**
 * [WhiteNoise]: exactly one of [intensity], and [temperature] with a [drag].
 *
 * @property intensity ξ² of the noise, the same for all particles, (length/time)² per unit of time
 * @property temperature T of a bath, mass · (length/time)²; then ξ² is 2 γ T/m
 * @property drag γ, per unit of time
 * @property conserveMomentum whether the sum of the kicks is taken back
 */
@OptIn(ExperimentalSerializationApi::class)
@Serializable
@SerialName("white-noise")
@Described("a thermostat: each particle is accelerated by noise of its own")
public class WhiteNoiseSpec @JvmOverloads constructor(
    @Described("ξ², length²/time³; of this and `temperature` exactly one")
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val intensity: Double? = null,
    @Described("T, mass · speed², of Langevin's bath: ξ² = 2 γ T/m")
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val temperature: Double? = null,
    @Described("γ, 1/time; default 0")
    public val drag: Double = 0.0,
    @Described("whether the sum of the kicks is taken back; default false")
    public val conserveMomentum: Boolean = false,
) : ForceSpec {
    override val actsOnDiscs: Boolean get() = true
    override val noise: WhiteHeating get() = WhiteHeating(drag) { intensity ?: (2 * drag * temperature!! / it) }

    override fun force(place: ForcePlace): Force {
        val check = place.check
        val key = place.key
        check.must(key, (intensity == null) != (temperature == null)) {
            "needs exactly one of intensity and temperature"
        }
        check.atLeast0("$key.drag", drag)
        intensity?.let { check.atLeast0("$key.intensity", it) }
        temperature?.let {
            check.atLeast0("$key.temperature", it)
            check.that("$key.drag", drag, drag > 0) { "must be greater than 0; a bath of that temperature needs it" }
        }
        val made = intensity ?: (2 * drag * temperature!!)
        check.must(key, made.isFinite()) { "makes noise of intensity $made; it must be finite" }
        return WhiteNoise(
            place.ownSeed,
            made,
            drag,
            temperature != null,
            conserveMomentum,
            place.boundary,
            place.firstBody,
        )
    }

    override fun inWords(place: ForcePlace, population: Population, say: Quantities): String = listOfNotNull(
        intensity?.let { "white noise of intensity ${say.heating(it)}" }
            ?: "white noise of a bath at temperature ${number(temperature!!)} (mass x speed^2)",
        if (drag > 0) "drag ${say.rate(drag)}" else null,
        if (conserveMomentum) CONSERVES else null,
    ).joinToString()
}

/**
 * [Andersen]'s bath.
 *
 * @property rate at which each particle gets a new velocity, per unit of time
 * @property temperature T of the bath, mass · (length/time)²
 * @property conserveMomentum whether the sum of the changes is taken back
 */
@Serializable
@SerialName("andersen")
@Described("a thermostat: each particle gets a new velocity out of a bath at this rate")
public class AndersenSpec @JvmOverloads constructor(
    @Described("per particle, 1/time")
    public val rate: Double,
    @Described("of the bath, mass · speed²")
    public val temperature: Double,
    @Described("whether the sum of the changes is taken back; default false")
    public val conserveMomentum: Boolean = false,
) : ForceSpec {
    override val actsOnDiscs: Boolean get() = true

    override fun force(place: ForcePlace): Force {
        place.check.atLeast0("${place.key}.rate", rate)
        place.check.atLeast0("${place.key}.temperature", temperature)
        return Andersen(place.ownSeed, rate, temperature, conserveMomentum, place.boundary, place.firstBody)
    }

    override fun inWords(place: ForcePlace, population: Population, say: Quantities): String = listOfNotNull(
        "Andersen's bath at temperature ${number(temperature)} (mass x speed^2), new velocities at ${say.rate(rate)}",
        if (conserveMomentum) CONSERVES else null,
    ).joinToString()
}

/**
 * See [Rescaling].
 *
 * @property temperature T, mass · (length/time)²
 * @property time of relaxation; 0 for at once
 */
@Serializable
@SerialName("rescaling")
@Described("a thermostat: velocities are scaled to this temperature; conserves momentum")
public class RescalingSpec @JvmOverloads constructor(
    @Described("mass · speed²")
    public val temperature: Double,
    @Described("within which it is reached; 0 is at each step; default 0")
    public val time: Double = 0.0,
) : ForceSpec {
    override val actsOnDiscs: Boolean get() = true

    override fun force(place: ForcePlace): Force {
        place.check.atLeast0("${place.key}.temperature", temperature)
        place.check.atLeast0("${place.key}.time", time, "0 for at once")
        return Rescaling(temperature, time, place.boundary, place.firstBody)
    }

    override fun inWords(place: ForcePlace, population: Population, say: Quantities): String =
        "velocities scaled to temperature ${number(temperature)} (mass x speed^2), " +
            if (time == 0.0) "at each step" else "within ${say.time(time)}"
}

private const val CONSERVES = "momentum conserved"
