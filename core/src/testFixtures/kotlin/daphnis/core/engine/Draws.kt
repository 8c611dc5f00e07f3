package daphnis.core.engine

/**
 * How many cases tests draw. `daphnis.long` asks for many, `daphnis.share` for so many per cent of the usual number,
 * `daphnis.draws` for exactly so many; `daphnis.firstDraw` says with which they begin.
 */
object Draws {
    val isLong: Boolean = System.getProperty("daphnis.long") == "true"

    val first: Long = java.lang.Long.getLong("daphnis.firstDraw", 1)

    private val percent = java.lang.Long.getLong("daphnis.share", 100)

    /** The number of cases of a test that draws [usual] ones, and [long] where there is time for it. */
    fun of(usual: Long, long: Long): Long = java.lang.Long.getLong("daphnis.draws", share(usual, long))

    /** The same for a test whose number of cases is not that of the contracts. */
    fun share(usual: Long, long: Long): Long = if (isLong) long else maxOf(1, usual * percent / 100)
}
