package daphnis.core.table

import daphnis.core.input.UnitsSpec
import kotlin.math.abs

/**
 * What the units of quantities are called in a scenario with [units]: `m`, `m/s` where they are metric, else by what
 * they measure, `units of length`, `units of length^2/time`. Powers are written `^2`. Null for a run without a
 * scenario, whose units nobody knows.
 */
public class UnitsOfDimensions(units: UnitsSpec?) {
    private val names: Map<String, String?> = mapOf(
        Dimension.LENGTH to nameOf(units?.lengthInMetres, LENGTHS),
        Dimension.TIME to nameOf(units?.timeInSeconds, TIMES),
        // The mass in kilograms has a default; it means something only where the length is known.
        Dimension.MASS to nameOf(units?.massInKg.takeIf { units?.lengthInMetres != null }, MASSES),
    )

    /**
     * The unit of a quantity whose [dimension] is written with the words length, time and mass, as in [Dimension];
     * metric only when all of them are. Empty for a pure number.
     */
    public fun of(dimension: String): String {
        val words = names.keys.filter { it in dimension }
        if (words.isEmpty()) return dimension
        if (words.any { names[it] == null }) return UNNAMED + dimension
        val unit = words.fold(dimension) { text, word -> text.replace(word, names.getValue(word)!!) }
        return if (unit == JOULE) "J" else unit
    }

    /** The name of [word], one of length, time and mass; null where it has none. */
    public fun nameOrNull(word: String): String? = names[word]

    public companion object {
        /** Begins what a unit without a name is called. */
        public const val UNNAMED: String = "units of "
        private const val CLOSE = 1e-12
        private const val JOULE = "kg m^2/s^2"
        private val LENGTHS = listOf(0.01 to "cm", 1.0 to "m", 1000.0 to "km")
        private val TIMES = listOf(1.0 to "s")
        private val MASSES = listOf(0.001 to "g", 1.0 to "kg")

        private fun nameOf(inSi: Double?, known: List<Pair<Double, String>>) =
            inSi?.let { size -> known.find { abs(size / it.first - 1) < CLOSE }?.second }

        /** The head of a column: `time [s]`, or [name] alone for a pure number. */
        @JvmStatic
        public fun head(name: String, unit: String): String = if (unit.isEmpty()) name else "$name [$unit]"

        /** The name of the column with [head], with or without a unit: tables of older versions have none. */
        @JvmStatic
        public fun nameIn(head: String): String = if (head.endsWith(']')) head.substringBefore(" [") else head
    }
}
