package daphnis.core.collision

import daphnis.core.population.ExactSums

/** Sums over the collisions of records. Each kind has its place in [StepTally][daphnis.core.engine.StepTally]. */
internal abstract class RecordSums : ExactSums() {
    /** Adds the collisions of [record] that these sums are over. */
    abstract fun add(record: CollisionRecord)
}
