package daphnis.app.sweep

import daphnis.analysis.table.UnitNames
import daphnis.core.input.UnitsSpec
import daphnis.core.table.Dimension
import daphnis.core.table.UnitsOfDimensions

/** What an axis calls a key of a scenario: its words and unit, `restitution: coefficient`, `bodies[0]: radius [m]`. */
internal class KeyLabel(units: UnitsSpec?) {
    private val units = UnitsOfDimensions(units)

    fun of(path: String): String {
        val last = path.substringAfterLast('.')
        val name = last.substringBefore('[')
        val unit = FIXED[path] ?: FIXED[name] ?: units.of(DIMENSIONS[path] ?: DIMENSIONS[name].orEmpty())
        val before = if (last == path) "" else "${words(path.substringBeforeLast('.'))}: "
        return before + UnitNames.axis(words(UNITS_IN_NAME.replace(last, "")), unit)
    }

    /** `opticalDepth` is optical depth. */
    private fun words(key: String) = key.replace(Regex("(?<=[a-z])[A-Z]")) { " ${it.value.lowercase()}" }

    private companion object {
        val UNITS_IN_NAME = Regex("In(Km|Kg|Metres|CmPerSecond)$|Orbits$")

        /** Units that keys have whatever the scenario's are. */
        val FIXED = mapOf(
            "distanceInKm" to "km",
            "radiusInKm" to "km",
            "gravitationalParameter" to "km^3/s^2",
            "massInKg" to "kg",
            "lengthInMetres" to "m",
            "speedInCmPerSecond" to "cm/s",
            "criticalSpeed" to "cm/s",
            "untilOrbits" to "orbits",
            "phase" to "rad",
            // Laws of restitution are in cm/s.
            "restitution.speed" to "cm/s",
        )

        /**
         * Dimensions of keys by their last part, which mean the same wherever they stand, or by all of it; others are
         * pure numbers, such as `particles.sizes.sigma`, which is of ln r.
         */
        val DIMENSIONS: Map<String, String> = listOf(
            Dimension.LENGTH to "lengths radius radii minimum maximum median position softening x y e cell",
            Dimension.TIME to "until dt duration longest time",
            Dimension.MASS to "mass",
            Dimension.SPEED to "velocityJump halfWidth speed velocity velocities.sigma",
            Dimension.SPEED_SQUARED to "temperature",
            Dimension.ANGULAR_SPEED to "angularSpeed shearRate spins.sigma spins.mean",
            Dimension.ENERGY to "spins.temperature",
            "length/time^2" to "acceleration",
            "mass/length^2" to "surfaceDensity",
            "mass/length^3" to "density",
        ).flatMap { (dimension, names) -> names.split(' ').map { it to dimension } }.toMap()
    }
}
