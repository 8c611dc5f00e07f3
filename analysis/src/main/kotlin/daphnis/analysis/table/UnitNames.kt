package daphnis.analysis.table

import daphnis.core.input.UnitsSpec
import daphnis.core.table.Dimension
import daphnis.core.table.UnitsOfDimensions

/**
 * What the units of a scenario are called: `m`, `m/s` where they are metric, else by what they measure, `units of
 * length`, `units of length^2/time`. Powers are written `^2`, as tables in CSV have them; [raised] makes them readable.
 *
 * @param clock what states are counted in, such as `steps` of a file without times; null for the unit of time
 */
public class UnitNames @JvmOverloads constructor(units: UnitsSpec?, clock: String? = null) {
    private val names = UnitsOfDimensions(units)

    public val length: String = of(Dimension.LENGTH)

    /** Of the times of states; other quantities have the scenario's unit of time in any case. */
    public val time: String = clock ?: of(Dimension.TIME)
    public val mass: String = of(Dimension.MASS)
    public val speed: String = of(Dimension.SPEED)

    /** Of ⟨c²⟩/3. */
    public val temperature: String = of(Dimension.SPEED_SQUARED)
    public val energy: String = of(Dimension.ENERGY)
    public val area: String = of("length^2")
    public val viscosity: String = of("length^2/time")
    public val surfaceDensity: String = of("mass/length^2")
    public val density: String = of("mass/length^3")

    /** Of a frequency. */
    public val rate: String = inverse("time")
    public val waveNumber: String = inverse("length")

    /**
     * The unit of a quantity whose [dimension] is written with the words length, time and mass; metric only when all of
     * them are.
     */
    public fun of(dimension: String): String = names.of(dimension)

    private fun inverse(word: String) = "1/" + (names.nameOrNull(word) ?: "(unit of $word)")

    public companion object {
        private const val UNITS_OF = UnitsOfDimensions.UNNAMED

        /** A [number] with its [unit]: `2 units of length`, but `1 unit of length`; `2 per unit of time`; `5 m`. */
        @JvmStatic
        public fun amount(number: String, unit: String): String = when {
            number == "1" && unit.startsWith(UNITS_OF) -> "1 unit of ${unit.removePrefix(UNITS_OF)}"
            unit.startsWith("1/(") -> "$number per ${unit.removeSurrounding("1/(", ")")}"
            else -> "$number $unit"
        }

        /** Powers raised: `m^2/s` reads m²/s. */
        @JvmStatic
        public fun raised(unit: String): String = unit.replace("^2", "²").replace("^3", "³").replace("^-1", "⁻¹")

        /** What stands at an axis: [quantity] with its [unit] in brackets, or alone for a pure number. */
        @JvmStatic
        public fun axis(quantity: String, unit: String): String =
            if (unit.isEmpty()) quantity else "$quantity [${raised(unit)}]"
    }
}
