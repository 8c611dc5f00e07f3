package daphnis.core.engine.horizon

import daphnis.core.collision.CollisionRecord
import daphnis.core.growth.IntList
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.search.StepBounds
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/** The spheres that an [Epoch] carries through steps, and where it writes them. */
internal interface Carried {
    val spheres: SphereColumns

    /** Where collisions are to be written; null when they are not wanted. */
    val record: CollisionRecord?

    /** Which spheres are there, where they come and go from step to step; null where all stay. */
    val visits: Visits?

    /** Whether the first [count] of [spheres] are those that the step before has ended with. */
    fun follow(count: Int): Boolean

    /** Measures the step, see [PreparedStep.measureAlong]. */
    fun measure(along: StepBounds.AlongPieces?)

    /** See [daphnis.core.population.Population.columnsToWrite]; there may be more room than there are spheres. */
    fun columnsToWrite(tracksLastCollision: Boolean, keepsOrder: Boolean): PopulationColumns

    /** Takes back columns that are not written to any more. */
    fun giveBack(columns: PopulationColumns)

    /** Makes [columns] the spheres. */
    fun take(columns: PopulationColumns)
}

/** Spheres of an epoch that come and go. One that is away keeps its slot, and is as if it were not. */
internal interface Visits {
    /** Slots of spheres that are there now and were not in the step before; new slots are the last. */
    val entered: IntList

    /** Slots of those that have gone since the step before. */
    val left: IntList

    fun isHere(slot: Int): Boolean
}

/** All spheres of a step. */
internal class WholePopulation(private val prepared: PreparedStep, private val loop: RangeLoop) : Carried {
    lateinit var step: CollisionStep
    private val population get() = step.population
    override val spheres: SphereColumns get() = population
    override val record: CollisionRecord? get() = step.record
    override val visits: Visits? get() = null

    override fun follow(count: Int): Boolean = count == population.size

    override fun measure(along: StepBounds.AlongPieces?): Unit = prepared.measureAlong(step, loop, along)

    override fun columnsToWrite(tracksLastCollision: Boolean, keepsOrder: Boolean): PopulationColumns =
        population.columnsToWrite(tracksLastCollision, keepsOrder = keepsOrder)

    override fun giveBack(columns: PopulationColumns): Unit = population.giveBack(columns)

    override fun take(columns: PopulationColumns): Unit = population.take(columns)
}
