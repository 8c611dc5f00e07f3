package daphnis.core.cluster

import java.util.Locale

/** What the division of spheres among nodes has cost in a run. */
internal class CrewReport {
    private var steps = 0L
    private var spheres = 0L
    private var copies = 0L
    private var bytes = 0L
    private var redone = 0L
    private var nodes = 0
    private var before: List<NodeCost> = emptyList()

    /** Takes one step into account, of which each node tells what it has [done]. */
    fun add(done: List<StepDone>) {
        val now = done.map { it.cost }
        // Nodes count from the beginning of their crew.
        if (before.size != now.size || now[0].bytesSent < before[0].bytesSent) before = emptyList()
        steps++
        nodes = done.size
        spheres += done[0].total
        copies += now.sumOf { it.haloSpheres.toLong() }
        bytes += now.sumOf { it.bytesSent } - before.sumOf { it.bytesSent }
        redone += now[0].redone - (before.firstOrNull()?.redone ?: 0)
        before = now
    }

    /** All of it; null before the first step. */
    fun line(): String? {
        if (steps == 0L) return null
        val share = if (spheres == 0L) 0.0 else 100.0 * copies / spheres
        return String.format(
            Locale.ROOT,
            "%s at the end: %.1f %% of the spheres in halos, %d steps computed again, %.0f kB per step",
            if (nodes == 1) "1 node" else "$nodes nodes",
            share,
            redone,
            bytes / 1000.0 / steps,
        )
    }
}
