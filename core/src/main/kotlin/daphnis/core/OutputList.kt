package daphnis.core

/** Outputs that are called together, in their order. One thread opens and writes; any thread may [close]. */
internal class OutputList(private val outputs: List<Output>) {
    private val lock = Any()
    private var inUse = false
    private var isClosed = false

    /** How many are open. */
    private var opened = 0

    /**
     * How many outputs have seen the present state. It is above 0 after one threw; the outputs before that one are not
     * called again.
     */
    private var shown = 0

    val isEmpty: Boolean get() = outputs.isEmpty()

    /** Opens those that are not yet open. */
    fun open(simulation: Simulation, opening: Opening) = whileInUse {
        while (opened < outputs.size) {
            outputs[opened].open(simulation, opening)
            opened++
        }
    }

    /** Shows the state to the outputs that have not seen it. */
    fun write(simulation: Simulation) = whileInUse {
        while (shown < outputs.size) {
            outputs[shown].write(simulation)
            shown++
        }
        shown = 0
    }

    fun finish(simulation: Simulation) = whileInUse { for (output in outputs) output.finish(simulation) }

    /**
     * Closes those that are open, last to first, each even if another throws. A call under way on another thread ends
     * first, and that thread then closes them. When an output itself asks for closing, the thread that called the
     * output closes them.
     */
    fun close() {
        synchronized(lock) {
            if (isClosed) return
            isClosed = true
            if (inUse) return
        }
        closeOpened()
    }

    /** Does [act], and then closes the outputs if that was asked for meanwhile. */
    private inline fun whileInUse(act: () -> Unit) {
        synchronized(lock) {
            check(!isClosed) { "the simulation is closed" }
            inUse = true
        }
        try {
            act()
        } catch (e: Throwable) {
            if (isOver()) AutoCloseable { closeOpened() }.use { throw e }
            throw e
        }
        if (isOver()) closeOpened()
    }

    /** Ends the use. @return whether the outputs are to be closed now */
    private fun isOver(): Boolean = synchronized(lock) {
        inUse = false
        isClosed
    }

    private fun closeOpened() {
        closeAll(outputs.take(opened).map { AutoCloseable { it.close() } })
        opened = 0
    }
}

/** Closes each of [all], last to first, even if another throws. */
internal fun closeAll(all: Iterable<AutoCloseable>) {
    all.fold(AutoCloseable {}) { before, next -> AutoCloseable { before.use { next.close() } } }.close()
}
