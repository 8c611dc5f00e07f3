package daphnis.core.cluster.bricks

import daphnis.core.population.SphereColumns

/**
 * Names an attempt at a step. Whatever is late, or comes twice, is known by it.
 *
 * @property epoch of the [Territory]
 * @property step counted by the engine
 * @property attempt 0 at first; one more with each [Redo]
 */
internal data class AttemptKey(val epoch: Int, val step: Long, val attempt: Int) : Comparable<AttemptKey> {
    /** The next attempt at the same step. */
    val next: AttemptKey get() = AttemptKey(epoch, step, attempt + 1)

    override fun compareTo(other: AttemptKey): Int = when {
        epoch != other.epoch -> epoch.compareTo(other.epoch)
        step != other.step -> step.compareTo(other.step)
        else -> attempt.compareTo(other.attempt)
    }
}

/**
 * What bricks and the [Agreement] tell one another. Arrays within belong to the sender, who changes them only in the
 * next step, or attempt; by then all have read them, since none goes on before all have answered.
 *
 * @property key the attempt to which it belongs
 * @property from number of the brick that sent it; [AGREEMENT] for none
 */
internal sealed interface BrickMessage {
    val key: AttemptKey
    val from: Int

    companion object {
        /** The number of the [Agreement]. */
        const val AGREEMENT = -1
    }
}

/**
 * Node → node: those of the spheres which the sender held at the start of the step that the receiver needs.
 *
 * @property own entries of [spheres] that are in the receiver's territory now
 * @property near entries that are in its halo
 */
internal class Halo(
    override val key: AttemptKey,
    override val from: Int,
    val spheres: SphereColumns,
    val own: IndexRuns,
    val near: IndexRuns,
) : BrickMessage

/**
 * Node → node: how the sender has found those of its own spheres to move that are in the receiver's halo.
 *
 * @property paths whole hashes of their paths
 * @property bound how far any sphere could go along x, y, z in the sender's computation
 */
internal class Outcome(
    override val key: AttemptKey,
    override val from: Int,
    val paths: PathList,
    val bound: DoubleArray,
) : BrickMessage

/**
 * Node → agreement: whether the sender has worked with the right paths of all spheres in its sight.
 *
 * @property bound how far any sphere could go along x, y, z in its computation
 * @property counts of its own spheres and impacts in this attempt
 * @property hasFailed whether its computation has ended with an exception, which may come from a wrong guess
 */
internal class Agreed(
    override val key: AttemptKey,
    override val from: Int,
    val isRight: Boolean,
    val bound: DoubleArray,
    val counts: BrickCounts,
    val hasFailed: Boolean = false,
) : BrickMessage

/**
 * What a brick counts in a step, or several together.
 *
 * @property spheres that it owns
 * @property collisions of spheres of which it owns the one with the lower id
 * @property wallCollisions of its spheres
 */
internal data class BrickCounts(val spheres: Long, val collisions: Long, val wallCollisions: Long) {
    operator fun plus(other: BrickCounts): BrickCounts = BrickCounts(
        spheres + other.spheres,
        collisions + other.collisions,
        wallCollisions + other.wallCollisions,
    )

    companion object {
        val NONE = BrickCounts(0, 0, 0)
    }
}

/** Agreement → nodes: all were right at once, so what each has found for its own spheres is the step. */
internal class Go(override val key: AttemptKey) : BrickMessage {
    override val from: Int get() = BrickMessage.AGREEMENT
}

/**
 * Agreement → nodes: another attempt, named by [key]. Those that were not right compute again, with wider halos; all
 * compare again, because paths that were right may have been compared with wrong ones.
 *
 * @property again by brick, whether it computes again
 */
internal class Redo(override val key: AttemptKey, val widths: HaloWidths, val again: BooleanArray) : BrickMessage {
    override val from: Int get() = BrickMessage.AGREEMENT
}

/** Brings messages on their way. They may arrive in any order, and more than once. */
internal fun interface Post {
    /** Sends [message] to brick [to], or to [BrickMessage.AGREEMENT]. */
    fun send(to: Int, message: BrickMessage)
}
