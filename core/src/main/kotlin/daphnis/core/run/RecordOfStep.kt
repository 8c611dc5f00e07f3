package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.RecordSums

/** The collisions of the last step. @throws IllegalStateException when they are not recorded */
internal fun Simulation.recordOfStep(): CollisionRecord = checkNotNull(collisions?.record) {
    "collisions are not recorded; make CollisionForcing with recordCollisions = true"
}

/**
 * Adds the collisions of the last step to [sums], or what nodes have summed of them.
 *
 * @throws IllegalStateException when they are not recorded
 */
internal fun Simulation.addStepTo(sums: RecordSums) {
    val tally = collisions?.tally
    if (tally != null) tally.addTo(sums) else sums.add(recordOfStep())
}
