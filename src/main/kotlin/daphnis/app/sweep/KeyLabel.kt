package daphnis.app.sweep

import daphnis.analysis.table.UnitNames
import daphnis.core.scenario.UnitsSpec
import daphnis.core.table.Dimension
import daphnis.core.table.UnitsOfDimensions

/** What an axis calls a key of a scenario: its words and unit, `restitution: coefficient`, `bodies[0]: radius [m]`. */
internal class KeyLabel(units: UnitsSpec?) {
    private val units = UnitsOfDimensions(units)

    fun of(path: String): String {
        val last = path.substringAfterLast('.')
        val name = last.substringBefore('[')
        val unit = FIXED[name] ?: units.of(if (path == SIGMA) Dimension.SPEED else DIMENSIONS[name].orEmpty())
        val before = if (last == path) "" else "${words(path.substringBeforeLast('.'))}: "
        return before + UnitNames.axis(words(UNITS_IN_NAME.replace(last, "")), unit)
    }

    /** `opticalDepth` is optical depth. */
    private fun words(key: String) = key.replace(Regex("(?<=[a-z])[A-Z]")) { " ${it.value.lowercase()}" }

    private companion object {
        /** `particles.sizes.sigma`, of ln r, is a number. */
        const val SIGMA = "velocities.sigma"
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
        )

        /** Dimensions of keys by their last part, which mean the same wherever they stand; others are pure numbers. */
        val DIMENSIONS: Map<String, String> = listOf(
            Dimension.LENGTH to "lengths radius radii minimum maximum median position softening x y e cell",
            Dimension.TIME to "until dt duration longest time",
            Dimension.MASS to "mass",
            Dimension.SPEED to "velocityJump halfWidth speed velocity",
            Dimension.SPEED_SQUARED to "temperature",
            "1/time" to "angularSpeed shearRate",
            "length/time^2" to "acceleration",
            "mass/length^2" to "surfaceDensity",
            "mass/length^3" to "density",
        ).flatMap { (dimension, names) -> names.split(' ').map { it to dimension } }.toMap()
    }
}
