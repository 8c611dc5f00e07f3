package daphnis.core.input

/**
 * The units of a scenario in SI units.
 *
 * @property metres in one unit of length
 * @property seconds in one unit of time
 * @property kilograms in one unit of mass
 */
public class SiUnits(public val metres: Double, public val seconds: Double, public val kilograms: Double)
