package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.Pistons
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.EndsFinite
import daphnis.core.force.Drift
import daphnis.core.force.Force
import daphnis.core.force.uniformAcceleration
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.forEachPiece
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.population.firstNotFinite
import daphnis.core.population.isFinite
import daphnis.core.source.Sources
import daphnis.core.surface.SurfaceContact
import java.util.function.Supplier

/**
 * The phases of a step, for the code which drives it: [begin] · [duration] · [kick] · [drift] · [applyBoundary] ·
 * [kickAgain] · [swap] · [exchange] · [checkFinite] · [commit]. A [Simulation] calls them one after the other; where
 * nodes hold the spheres,
 * each node does so on its part of the population. Until [commit], all phases together can be taken back. One thread
 * calls; [loop] may use more.
 *
 * @param collisions null for spheres that pass through one another
 * @param forces in the order in which they act before the drift; they have been given their loop
 */
public class StepPhases internal constructor(
    private val population: Population,
    private val boundary: BoundaryConditions,
    private val collisions: CollisionForcing?,
    private val forces: List<Force>,
    private val loop: RangeLoop,
    private val partition: Partition,
    private val sources: Sources?,
) {
    public constructor(
        population: Population,
        boundary: BoundaryConditions,
        collisions: CollisionForcing?,
        forces: List<Force>,
        loop: RangeLoop,
    ) : this(population, boundary, collisions, forces, loop, Partition.Whole, null)

    init {
        val drift = forces.firstNotNullOfOrNull { it as? Drift }
        collisions?.turning = drift?.turning ?: 0.0
        // What a frame makes of paths is not a parabola: there the paths that walls meet are straight.
        if (drift == null) collisions?.acceleration = uniformAcceleration(forces)
    }

    /** Null where no wall is a piston. */
    private val pistons = Pistons.of(boundary, collisions?.record, population, partition)

    private val carried = CarriedState(boundary, forces)

    /** What [boundary] is in the step under way. */
    private var present = boundary

    private val undo = StepUndo(population, collisions?.counters)

    /** Whether the state at the end of the step is known to be finite. */
    @Volatile
    private var isKnownFinite = false

    /** Whether the engine knows that of the state after the drift of this step. */
    private var hasDriftedFinite = false

    /** A step begins. */
    public fun begin() {
        isKnownFinite = false
        hasDriftedFinite = false
        undo.begin()
        carried.begin()
    }

    /** The length of a step that starts now. */
    public fun duration(timeStep: TimeStep): Double = if (timeStep is PerSphereTimeStep) {
        timeStep.next(timeStep.measure(population, loop))
    } else {
        timeStep.next(population)
    }

    /** Forces act for the first half of a step that begins at [start]. */
    public fun kick(start: Double, duration: Double) {
        if (forces.isNotEmpty()) undo.keepVelocities(loop)
        for (k in forces.indices) forces[k].beforeDrift(population, start, duration)
    }

    /** Moves every sphere along its path to the end of the step, with every collision in time order. */
    public fun drift(start: Double, duration: Double) {
        present = boundary.during(start, duration) ?: boundary
        if (collisions != null) {
            collisions.advance(population, present, start, duration)
            collisions.scatter(population, partition, start)
            // Another engine around that one may have written more.
            hasDriftedFinite = (collisions.engine as? EndsFinite)?.endedFinite == true
        } else {
            population.drift(duration)
        }
    }

    /**
     * Brings back or removes the spheres that are beyond the boundary at the [end] of the step. Nothing else is to
     * write the population between [drift] and this.
     */
    public fun applyBoundary(end: Double) {
        val boundary = present
        if (boundary !is PerSphereBoundary) {
            boundary.endStep(population, end)
            val gone = population.news?.takeRemoved() ?: IntArray(0)
            if (collisions?.states != null) population.forget(partition.gather(gone))
            return
        }
        // Without forces nothing else is done to the spheres, which are in the cache here.
        isKnownFinite = forces.isEmpty()
        val isFiniteAnyway = hasDriftedFinite && boundary.keepsFinite(boundary)
        loop.runLight(population.size) { _, from, to ->
            forEachPiece(from, to) { first, last ->
                boundary.endStep(population, end, first, last)
                if (isKnownFinite && !isFiniteAnyway && !population.isFinite(first, last)) isKnownFinite = false
            }
        }
    }

    /**
     * Pistons take up their impacts, and forces act for the second half of a step that ended at [end], in the reverse
     * order.
     */
    public fun kickAgain(end: Double, duration: Double) {
        pistons?.move(duration, end)
        for (k in forces.indices.reversed()) forces[k].afterDrift(population, end, duration)
    }

    /** Spheres swap places at the [end] of a step that began at [start]. */
    public fun swap(start: Double, end: Double) {
        collisions?.swap(population, boundary, partition, start, end)
    }

    /** Spheres come and leave at the [end] of a step. */
    internal fun exchange(end: Double, duration: Double) {
        sources?.act(population, partition, present, end, duration, collisions?.momentFactor ?: SurfaceContact.SOLID)
    }

    /** @throws IllegalStateException when the state is not finite; its message says [at] which step and time */
    public fun checkFinite(at: Supplier<String>) {
        if (isKnownFinite) return
        population.firstNotFinite(loop)?.let { error("the state is no longer finite after ${at.get()}: $it") }
    }

    /** The step stands. */
    public fun commit() {
        undo.commit()
    }

    /**
     * Restores population and counters to what they were at [begin]; the record of collisions is empty. Allocates
     * nothing.
     */
    public fun takeBack() {
        undo.takeBack()
        carried.takeBack()
        sources?.sums?.clear()
        collisions?.record?.clear()
    }
}
