package daphnis.analysis.plot

/** Colours as `#rrggbb`. */
internal object Colours {
    /** The colour [part] of the way from [a] to [b]. */
    fun mixed(a: String, b: String, part: Double): String {
        val mixed = (1..5 step 2).map { k ->
            val from = a.substring(k, k + 2).toInt(HEX)
            Math.round(from + part * (b.substring(k, k + 2).toInt(HEX) - from)).toInt()
        }
        return mixed.joinToString("", "#") { it.toString(HEX).padStart(2, '0') }
    }

    private const val HEX = 16
}
