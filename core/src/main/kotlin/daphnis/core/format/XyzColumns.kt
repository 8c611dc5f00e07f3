package daphnis.core.format

import daphnis.core.population.SphereQuantity

/**
 * The places of the columns in a line of extended XYZ, from its [properties], a repeated `name:type:count`. Columns
 * that are not there are −1.
 *
 * @param fail refuses the file
 */
internal class XyzColumns(properties: String, fail: (String) -> Nothing) {
    private val places = HashMap<List<String>, Int>()

    /** Names of columns that are not used, but for those that tell what a particle is made of. */
    val unused = ArrayList<String>()
    var width = 0
        private set

    init {
        val parts = properties.split(':')
        if (parts.size % 3 != 0) {
            fail("Properties '${TextLines.shown(properties)}' must be repeated name:type:count")
        }
        for (k in parts.indices step 3) {
            val count = parts[k + 2].trim().toIntOrNull()?.takeIf { it in 1..MOST_WIDE }
                ?: fail("Properties: '${TextLines.shown(parts[k + 2])}' must be a number of columns, 1 to $MOST_WIDE")
            val name = parts[k].trim().lowercase()
            val names = COUNTS.keys.find { name in it && count == COUNTS[it] }
            if (names == null) {
                if (name !in SILENT) unused += TextLines.shown(parts[k].trim())
            } else if (places.putIfAbsent(names, width) != null) {
                fail("Properties has two columns of ${names.joinToString()}")
            }
            width += count
            if (width > MOST_WIDE) fail("Properties has more than $MOST_WIDE columns")
        }
        if (SphereQuantity.POSITION.xyz !in places) fail("Properties has no pos:R:3")
    }

    /** The columns of [quantity], −1 when it is not there. */
    operator fun get(quantity: SphereQuantity): IntArray {
        val at = places[quantity.xyz]
        return IntArray(quantity.columns.size) { if (at == null) -1 else at + it }
    }

    /** The first column of what goes by [names], −1 when it is not there. */
    operator fun get(names: List<String>): Int = places[names] ?: -1

    operator fun contains(names: List<String>): Boolean = names in places

    /** Quantities that are there, or follow from what is. */
    val known: Set<SphereQuantity> = NUMBERED.filterTo(HashSet()) { quantity ->
        when (quantity) {
            SphereQuantity.VELOCITY -> quantity.xyz in this || MOMENTUM in this && SphereQuantity.MASS.xyz in this
            SphereQuantity.RADIUS -> quantity.xyz in this || DIAMETER in this
            else -> quantity.xyz in this
        }
    }

    /** Whether velocities are momenta by masses. */
    val velocityFollows: Boolean = SphereQuantity.VELOCITY.xyz !in this && SphereQuantity.VELOCITY in known

    companion object {
        /** As ASE writes it, in place of velocities. */
        val MOMENTUM = listOf("momenta", "momentum")
        val DIAMETER = listOf("diameter", "diameters")
        val ID = listOf("id", "ids")
        val SPECIES = listOf("species")
        val IMAGE = listOf("map_shift", "image", "images", "periodic_image")

        /** How many columns belong to a quantity, by the names that programs have for it. */
        private val COUNTS =
            NUMBERED.associate { it.xyz to it.columns.size } +
                mapOf(MOMENTUM to 3, DIAMETER to 1, ID to 1, IMAGE to 3, SPECIES to 1)
        private const val MOST_WIDE = 100_000
        private val SILENT = setOf("element", "type", "z", "numbers")
    }
}
