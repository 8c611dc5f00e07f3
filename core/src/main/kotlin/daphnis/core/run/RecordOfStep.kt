package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord

/** The collisions of the last step, for what sums them. @throws IllegalStateException when they are not recorded */
internal fun Simulation.recordOfStep(): CollisionRecord = checkNotNull(collisions?.record) {
    "collisions are not recorded; make CollisionForcing with recordCollisions = true"
}
