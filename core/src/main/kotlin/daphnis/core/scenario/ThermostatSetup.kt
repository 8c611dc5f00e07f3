package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.Force
import daphnis.core.force.thermostat.Andersen
import daphnis.core.force.thermostat.Rescaling
import daphnis.core.force.thermostat.WhiteNoise
import daphnis.core.input.ValueCheck

/** Makes the thermostats of a scenario. Each draws numbers of its own, by its place in the list of forces. */
internal class ThermostatSetup(
    private val seed: Long,
    private val boundary: BoundaryConditions,
    private val firstBody: Int,
    private val check: ValueCheck,
) {
    /** @param place in the list of forces */
    fun force(spec: ThermostatSpec, place: Int): Force {
        val key = "forces[$place]"
        val own = seed + (place + 1) * APART
        return when (spec) {
            is ThermostatSpec.WhiteNoise -> whiteNoise(spec, key, own)
            is ThermostatSpec.Andersen -> {
                check.that("$key.rate", spec.rate, spec.rate >= 0) { "must be at least 0" }
                temperature("$key.temperature", spec.temperature)
                Andersen(own, spec.rate, spec.temperature, spec.conserveMomentum, boundary, firstBody)
            }
            is ThermostatSpec.Rescaling -> {
                temperature("$key.temperature", spec.temperature)
                check.that("$key.time", spec.time, spec.time >= 0) { "must be at least 0 (0 for at once)" }
                Rescaling(spec.temperature, spec.time, boundary, firstBody)
            }
        }
    }

    private fun whiteNoise(spec: ThermostatSpec.WhiteNoise, key: String, seed: Long): WhiteNoise {
        check.must(key, (spec.intensity == null) != (spec.temperature == null)) {
            "needs exactly one of intensity and temperature"
        }
        check.that("$key.drag", spec.drag, spec.drag >= 0) { "must be at least 0" }
        val bath = spec.temperature
        val intensity = if (bath == null) {
            spec.intensity!!.also { check.that("$key.intensity", it, it >= 0) { "must be at least 0" } }
        } else {
            temperature("$key.temperature", bath)
            check.that("$key.drag", spec.drag, spec.drag > 0) {
                "must be greater than 0; a bath of that temperature needs it"
            }
            2 * spec.drag * bath
        }
        check.must(key, intensity.isFinite()) { "makes noise of intensity $intensity; it must be finite" }
        return WhiteNoise(
            seed,
            intensity,
            spec.drag,
            bath != null,
            spec.conserveMomentum,
            boundary,
            firstBody,
        )
    }

    private fun temperature(key: String, value: Double) = check.that(key, value, value >= 0) { "must be at least 0" }

    private companion object {
        /** Odd: no two thermostats of a run get the same seed, nor do those of seeds that are close. */
        const val APART = -0x61c8864680b583ebL
    }
}
