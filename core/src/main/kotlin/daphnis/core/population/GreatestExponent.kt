package daphnis.core.population

/** How large the terms of a sum are. */
internal object GreatestExponent {
    private const val FRACTION_BITS = 52

    /**
     * The greatest exponent, with its bias, among the entries [from] until [to] of [terms]. In four chains, which the
     * processor follows side by side.
     */
    fun of(terms: DoubleArray, from: Int, to: Int): Int {
        var a = 0L
        var b = 0L
        var c = 0L
        var d = 0L
        var k = from
        while (k < to - 3) {
            a = Math.max(a, magnitude(terms[k]))
            b = Math.max(b, magnitude(terms[k + 1]))
            c = Math.max(c, magnitude(terms[k + 2]))
            d = Math.max(d, magnitude(terms[k + 3]))
            k += 4
        }
        while (k < to) a = Math.max(a, magnitude(terms[k++]))
        return (Math.max(Math.max(a, b), Math.max(c, d)) ushr FRACTION_BITS).toInt()
    }

    /** The bits of a term without its sign, which are in the order of magnitudes. */
    private fun magnitude(term: Double): Long = term.toRawBits() and Long.MAX_VALUE
}
