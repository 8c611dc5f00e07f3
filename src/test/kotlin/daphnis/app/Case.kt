package daphnis.app

import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.engine.CollisionEngine
import daphnis.core.population.Population
import org.apache.pekko.actor.typed.ActorSystem

/** A start and its laws, for engines to agree on. */
interface Case {
    val seed: Long
    val population: Population
    val boundary: BoundaryConditions

    /** Length of a step. */
    val dt: Double

    /** Of a copy of the start. */
    fun simulation(engine: CollisionEngine): Simulation

    /** One of each parallel engine, with random threads and settings. */
    fun engines(host: ActorSystem<*>): List<CollisionEngine>
}
