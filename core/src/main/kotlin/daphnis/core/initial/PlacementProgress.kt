package daphnis.core.initial

import java.util.function.Supplier

/** Told how far a long placement has come. */
public fun interface PlacementWatcher {
    /** The [part] of the work, in [0, 1], is done; NaN where nobody knows. [what] says in words where it is. */
    public fun at(part: Double, what: String)
}

/**
 * Placements that take long tell what they do to whoever watches the thread that makes them: what makes a scenario's
 * initial state is far from what shows it.
 */
public object PlacementProgress {
    private val watchers = ThreadLocal<PlacementWatcher?>()

    /** Calls [make], and tells [watcher] of the placements that this thread makes in it. */
    @JvmStatic
    public fun <T> watched(watcher: PlacementWatcher, make: Supplier<T>): T {
        val before = watchers.get()
        watchers.set(watcher)
        try {
            return make.get()
        } finally {
            if (before == null) watchers.remove() else watchers.set(before)
        }
    }

    /** Tells, if anybody watches. */
    internal inline fun tell(part: Double, what: () -> String) {
        val watcher = present() ?: return
        watcher.at(part, what())
    }

    internal fun present(): PlacementWatcher? = watchers.get()
}
