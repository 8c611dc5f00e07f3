package daphnis.core.engine

import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population

/** A start and its laws, for engines to agree on. */
interface Case : EngineSettings {
    val seed: Long
    val population: Population
    val boundary: BoundaryConditions

    /** Length of a step. */
    val dt: Double

    /** Of a copy of the start. */
    fun simulation(engine: CollisionEngine): Simulation
}

/** What an engine under test is made with. */
interface EngineSettings {
    /** For what else an engine can be told than how many threads it has. */
    val random: SeededRandom

    /** How many threads; another number at each call. */
    fun threads(): Int
}

/** The same number of threads for every engine. */
class FixedThreads(private val threads: Int) : EngineSettings {
    override val random = SeededRandom(1)

    override fun threads(): Int = threads
}
