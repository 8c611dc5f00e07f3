package daphnis.core.format

/**
 * The places of the columns in a line of extended XYZ, from its [properties], a repeated `name:type:count`. Columns
 * that are not there are −1.
 *
 * @param fail refuses the file
 */
internal class XyzColumns(properties: String, fail: (String) -> Nothing) {
    var position = -1
        private set
    var velocity = -1
        private set
    var radius = -1
        private set
    var mass = -1
        private set
    var id = -1
        private set
    var width = 0
        private set

    init {
        val parts = properties.split(':')
        if (parts.size % 3 != 0) {
            fail("Properties '${TextLines.shown(properties)}' must be repeated name:type:count")
        }
        for (k in parts.indices step 3) {
            val count = parts[k + 2].toIntOrNull()?.takeIf { it in 1..MOST_WIDE }
                ?: fail("Properties: '${TextLines.shown(parts[k + 2])}' must be a number of columns, 1 to $MOST_WIDE")
            when (parts[k].lowercase()) {
                "pos" -> if (count == 3) position = width
                "velo", "vel", "velocity", "velocities" -> if (count == 3) velocity = width
                "radius" -> radius = width
                "mass", "masses" -> mass = width
                "id" -> id = width
            }
            width += count
            if (width > MOST_WIDE) fail("Properties has more than $MOST_WIDE columns")
        }
        if (position < 0) fail("Properties has no pos:R:3")
    }

    private companion object {
        const val MOST_WIDE = 100_000
    }
}
