package daphnis.core.format

/**
 * The places of the columns in a line of extended XYZ, from its [properties], a repeated `name:type:count`. Columns
 * that are not there are −1.
 *
 * @param fail refuses the file
 */
internal class XyzColumns(properties: String, fail: (String) -> Nothing) {
    private val places = HashMap<Quantity, Int>()

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
            val quantity = Quantity.entries.find { name in it.names && count == it.count }
            if (quantity == null) {
                if (name !in SILENT) unused += TextLines.shown(parts[k].trim())
            } else if (places.putIfAbsent(quantity, width) != null) {
                fail("Properties has two columns of ${quantity.names.joinToString()}")
            }
            width += count
            if (width > MOST_WIDE) fail("Properties has more than $MOST_WIDE columns")
        }
        if (Quantity.POSITION !in places) fail("Properties has no pos:R:3")
    }

    /** The first column of [quantity], −1 when it is not there. */
    operator fun get(quantity: Quantity): Int = places[quantity] ?: -1

    operator fun contains(quantity: Quantity): Boolean = quantity in places

    /** Whether velocities are there, or what they follow from. */
    val haveVelocity: Boolean
        get() = Quantity.VELOCITY in this || Quantity.MOMENTUM in this && Quantity.MASS in this

    /** What is read of a particle: [names] by which programs call it, lower case, and the [count] of its columns. */
    enum class Quantity(val count: Int, vararg val names: String) {
        POSITION(3, "pos", "positions", "position"),
        VELOCITY(3, "velo", "vel", "velocity", "velocities"),

        /** As ASE writes it, in place of velocities. */
        MOMENTUM(3, "momenta", "momentum"),
        RADIUS(1, "radius", "radii"),
        DIAMETER(1, "diameter", "diameters"),
        MASS(1, "mass", "masses"),
        ID(1, "id", "ids"),
        IMAGE(3, "map_shift", "image", "images", "periodic_image"),
    }

    private companion object {
        const val MOST_WIDE = 100_000
        val SILENT = setOf("species", "element", "type", "z", "numbers")
    }
}
