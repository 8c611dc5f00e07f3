package daphnis.core.population

/** One object per worker of a loop, made by [make] when it is first needed. */
internal class Workers<T>(private val make: () -> T) {
    private val all = ArrayList<T>()

    /** How many there are. */
    val count: Int get() = all.size

    operator fun get(worker: Int): T = all[worker]

    /** Sees to it that there are at least [workers]. */
    fun upTo(workers: Int) {
        while (all.size < workers) all += make()
    }
}
