package daphnis.core.input

/** The known word that a mistyped one most likely means. */
public object Nearest {
    /**
     * The one of [known] nearest to [word], ignoring case; null when even that differs by more than two changes and
     * half its length.
     */
    @JvmStatic
    public fun to(word: String, known: List<String>): String? {
        val given = word.take(LONGEST)
        val nearest = known.minByOrNull { distance(given, it) } ?: return null
        return nearest.takeIf { distance(given, it) <= maxOf(2, it.length / 2) }
    }

    /** The beginning of a message about [word]: "did you mean 'run'? ", or nothing. */
    @JvmStatic
    public fun question(word: String, known: List<String>): String =
        to(word, known)?.let { "did you mean '$it'? " }.orEmpty()

    /**
     * Edit distance, ignoring case: Levenshtein's, in which a swap of two neighbours counts as one change (optimal
     * string alignment).
     */
    internal fun distance(a: String, b: String): Int {
        fun same(i: Int, j: Int) = a[i].equals(b[j], ignoreCase = true)
        val rows = Array(a.length + 1) { IntArray(b.length + 1) }
        for (i in 0..a.length) rows[i][0] = i
        for (j in 0..b.length) rows[0][j] = j
        for (i in 1..a.length) {
            for (j in 1..b.length) {
                val change = if (same(i - 1, j - 1)) 0 else 1
                var least = minOf(rows[i - 1][j - 1] + change, rows[i - 1][j] + 1, rows[i][j - 1] + 1)
                if (i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1)) {
                    least = minOf(least, rows[i - 2][j - 2] + 1)
                }
                rows[i][j] = least
            }
        }
        return rows[a.length][b.length]
    }

    private const val LONGEST = 40
}
