package daphnis.core.engine

import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.HeatSums
import daphnis.core.collision.PairSums
import daphnis.core.collision.RecordSums
import daphnis.core.wall.WallSums

/**
 * The sums over the collisions of one step, for outputs that need no more of them: nodes send these in place of the
 * collisions.
 *
 * @param haveWalls whether walls move or are thermal
 * @param haveHeat whether the heat is summed that collisions carry
 */
internal class StepTally(private val haveWalls: Boolean, private val haveHeat: Boolean) {
    val all: List<RecordSums> =
        listOfNotNull(PairSums(), if (haveWalls) WallSums() else null, if (haveHeat) HeatSums() else null)

    /** Makes these the sums over [record]. */
    fun take(record: CollisionRecord) {
        clear()
        for (sums in all) sums.add(record)
    }

    fun clear() {
        for (sums in all) sums.clear()
    }

    /** Adds [other] sums of the same kinds. */
    fun merge(other: StepTally) {
        for (k in all.indices) all[k].merge(other.all[k])
    }

    /** Adds what there is of the kind of [sums] to them. */
    fun addTo(sums: RecordSums): Unit = sums.merge(all.first { it.javaClass == sums.javaClass })

    /** Which kinds there are, as a number for [of]. */
    val kinds: Int get() = (if (haveWalls) 1 else 0) + if (haveHeat) 2 else 0

    companion object {
        /** With these [kinds]. */
        fun of(kinds: Int): StepTally = StepTally(kinds and 1 != 0, kinds and 2 != 0)
    }
}
