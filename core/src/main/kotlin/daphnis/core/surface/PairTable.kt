package daphnis.core.surface

/**
 * What belongs to each pair of materials, in either order, by their numbers; [others] to all pairs of which nothing has
 * been said, and to walls. Immutable.
 */
internal class PairTable<T>(val others: T, private val rows: List<List<T>> = emptyList()) {
    /** What belongs to the materials of the numbers [first] and [second]. */
    operator fun get(first: Int, second: Int): T =
        if (first in rows.indices && second in rows.indices) rows[first][second] else others

    /** Number of materials of which anything is said. */
    val size: Int get() = rows.size

    /** All that is in the table, [others] first. */
    fun values(): List<T> = listOf(others) + rows.flatten()

    /** What belongs to the materials of two spheres in [contact]. */
    operator fun get(contact: SurfaceContact): T = get(contact.firstMaterial, contact.secondMaterial)

    /** Whether [holds] for anything in the table. */
    inline fun any(holds: (T) -> Boolean): Boolean = holds(others) || rows.any { row -> row.any(holds) }

    /** The same table, but with [value] for the pair [first], [second]. */
    fun with(first: Int, second: Int, value: T): PairTable<T> {
        require(first in 0 until MOST && second in 0 until MOST) {
            "materials are $first and $second; their numbers must be at least 0 and below $MOST"
        }
        val size = maxOf(rows.size, maxOf(first, second) + 1)
        val table = List(size) { i ->
            List(size) { j -> if (i == first && j == second || i == second && j == first) value else get(i, j) }
        }
        return PairTable(others, table)
    }
}

/** As many as there can be in a population. */
private const val MOST = 1000
