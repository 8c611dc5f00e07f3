package daphnis.app.describe

import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.scenario.ThermostatSpec

/** Thermostats in words. */
internal fun ThermostatSpec.inWords(say: Quantities): String = when (this) {
    is ThermostatSpec.WhiteNoise -> listOfNotNull(
        intensity?.let { "white noise of intensity ${say.heating(it)}" }
            ?: "white noise of a bath at temperature ${number(temperature!!)} (mass x speed^2)",
        if (drag > 0) "drag ${say.rate(drag)}" else null,
        if (conserveMomentum) CONSERVES else null,
    ).joinToString()
    is ThermostatSpec.Andersen -> listOfNotNull(
        "Andersen's bath at temperature ${number(temperature)} (mass x speed^2), new velocities at ${say.rate(rate)}",
        if (conserveMomentum) CONSERVES else null,
    ).joinToString()
    is ThermostatSpec.Rescaling ->
        "velocities scaled to temperature ${number(temperature)} (mass x speed^2), " +
            if (time == 0.0) "at each step" else "within ${say.time(time)}"
}

private const val CONSERVES = "momentum conserved"
