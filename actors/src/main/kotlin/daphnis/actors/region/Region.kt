package daphnis.actors.region

/**
 * The work of one region, without any framework. Its owner calls [serve] with one share after the other, from one
 * thread at a time, and each call happens after the one before.
 */
internal class Region(val number: Int) {
    /** Called with [number] before each share; for tests that make a region fail or wait. */
    var probe: (Int) -> Unit = {}

    /** Whether [serve] is running. */
    @Volatile
    var isAtWork: Boolean = false
        private set

    /**
     * Works on [share] and puts into [answers] how that ended. Throws nothing, since a framework that runs actors may
     * lose what they throw.
     */
    fun serve(share: Share, answers: Answers) {
        isAtWork = true
        try {
            probe(number)
            share.run(number)
            answers.put(number, null)
        } catch (e: Throwable) {
            answers.put(number, e)
        } finally {
            // After the answer, so that when neither this flag nor an answer is seen, none will come.
            isAtWork = false
        }
    }
}
