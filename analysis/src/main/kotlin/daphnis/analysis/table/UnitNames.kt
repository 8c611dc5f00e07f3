package daphnis.analysis.table

import daphnis.core.scenario.UnitsSpec

/** What the units of a scenario are called: SI where they are, else by their kind. */
public class UnitNames(units: UnitsSpec?) {
    public val length: String = when (units?.lengthInMetres) {
        1.0 -> "m"
        1000.0 -> "km"
        else -> "length"
    }
    public val time: String = if (units?.timeInSeconds == 1.0) "s" else "time"
    public val mass: String = if (units?.lengthInMetres != null && units.massInKg == 1.0) "kg" else "mass"
    public val speed: String get() = "$length/$time"
    public val viscosity: String get() = "$length^2/$time"
    public val surfaceDensity: String get() = "$mass/$length^2"
}
