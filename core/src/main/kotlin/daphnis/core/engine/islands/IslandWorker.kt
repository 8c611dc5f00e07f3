package daphnis.core.engine.islands

import daphnis.core.api.EngineApi
import daphnis.core.growth.IntList

/** Decides which spheres a worker may take into its islands. */
@EngineApi
public fun interface ClaimRule {
    public fun mayClaim(slot: Int): Boolean
}

/**
 * One of the workers on an [IslandField]: finds potential collisions, grows islands, processes and checks them. Its
 * results are in its own stores. The methods are the phases of a window; [IslandWorkers] has their order.
 *
 * ```
 *   propose, group ─▶ process ─▶ check ─▶ commit ─▶ hintSuspects
 *       Seeder        Grower    PathCheck      Committer
 * ```
 *
 * @param membersOf the members of a worker, by its number; used only to follow paths in another worker's islands
 */
@EngineApi
public class IslandWorker internal constructor(
    private val field: IslandField,
    number: Int,
    membersOf: (Int) -> Members,
) {
    internal val stores = WorkerStores()
    internal val seeder = Seeder(field, stores.hints)
    private val island = Island(field, number, stores)
    internal val grower = Grower(field, stores, island)
    internal val paths = PathCheck(field, stores, membersOf)
    internal val committer = Committer(field, number, stores)
    private val givenUp = IntList()

    /** Which spheres may join; null for any. */
    public var claimRule: ClaimRule?
        get() = island.claimRule
        set(rule) {
            island.claimRule = rule
        }

    /** For a new attempt at the step. */
    internal fun prepare() {
        val isRecorded = field.prepared.step.record != null
        stores.prepare(field.prepared.duration, field.limits)
        grower.begin(if (isRecorded) stores.tried else null)
        committer.record.clear()
    }

    /**
     * Finds every potential collision of the step that spheres [from] until [to] can have on the paths which they have
     * at its start.
     */
    public fun searchStart(from: Int, to: Int) {
        grower.candidates.start(from, to, stores.hints)
    }

    /** Makes seeds of the own hints of slices [from] to [to], and joins the islands that share one. */
    public fun propose(from: Int, to: Int) {
        stores.clearWindow(field.limits)
        seeder.propose(from, to, claimRule)
    }

    /** Hangs the own seeds into the lists of their islands. */
    public fun group() {
        seeder.group()
    }

    /**
     * Processes the island of [root] from its seeds to the end of the window.
     *
     * @return false when it was given up: the step is void or has failed, or the island needs a sphere that [claimRule]
     *   refuses; in that case everything is as if it had not been tried
     */
    public fun process(root: Int): Boolean = grower.grow(root)

    /**
     * Processes the islands that [group] found here first.
     *
     * @return those that had to be given up, see [process]
     */
    public fun processOwn(): IntArray = process(seeder.roots.size) { seeder.roots[it] }

    /**
     * Processes the islands of [roots].
     *
     * @return those that need a sphere which [claimRule] refuses, two numbers per island: its root and the slot of that
     *   sphere
     */
    public fun process(roots: IntArray): IntArray = process(roots.size) { roots[it] }

    private inline fun process(count: Int, rootAt: (Int) -> Int): IntArray {
        givenUp.clear()
        for (k in 0 until count) {
            val root = rootAt(k)
            if (grower.grow(root)) continue
            if (field.stopped) break
            givenUp.add(root)
            givenUp.add(island.refused)
        }
        return givenUp.toArray()
    }

    /** Compares the paths of spheres that came near those of other islands. */
    public fun check() {
        paths.run()
    }

    /** Copies the results of the islands that are alive into the state. */
    public fun commit() {
        committer.commit()
    }

    /** After all have committed: finds what spheres of different islands may do to one another in later windows. */
    public fun hintSuspects() {
        committer.hintSuspects()
    }
}
