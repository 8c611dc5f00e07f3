package daphnis.core.boundary

import daphnis.core.population.MeanFlow
import daphnis.core.population.Population

/**
 * What happens at the faces of the box. See [Box] for the axes.
 *
 * Two moments matter. **Within a step** spheres move on straight paths and may stick out of the box; [contactFaces] and
 * [shear] tell the contact search which images a sphere can hit, and walls reflect. **After the step** [endStep] brings
 * everybody back. A boundary of your own needs [box] and [endStep] alone: contacts are then searched inside only.
 */
public interface BoundaryConditions {
    /** The box; infinite bounds on open axes. */
    public val box: Box

    /** What the contact search does at the two faces across [axis] (0 = x, 1 = y, 2 = z). */
    public fun contactFaces(axis: Int): ContactFaces = ContactFaces.OPEN

    /** Whether a sphere that leaves through a face across [axis] comes back through the other. */
    public fun repeats(axis: Int): Boolean = contactFaces(axis) == ContactFaces.PERIODIC

    /** How images slide against one another, or null when they stand still. */
    public val shear: ImageShear? get() = null

    /**
     * The mean flow that the boundary drives, which a granular temperature has to leave out; null when there is none.
     */
    public val meanFlow: MeanFlow? get() = null

    /** Coefficient of restitution of walls, in [0, 1]; used where [contactFaces] says [ContactFaces.WALL]. */
    public val wallRestitution: Double get() = 1.0

    /**
     * Brings [population] back into the box at the end of a step that ended at [time]: may change positions and
     * velocities and may remove spheres. Must depend on each sphere's own state and [time] alone, so that the array
     * order cannot matter. A step that fails may be done again, with the same [time]. A boundary that wraps says so
     * with [Population.addCrossing], so that files can hold where a sphere has been.
     */
    public fun endStep(population: Population, time: Double)
}

/**
 * A boundary that brings spheres back one by one and removes none, so that engines with threads can do parts of a
 * population at the same time.
 */
public interface PerSphereBoundary : BoundaryConditions {
    /** [endStep] for the indices [from] until [to]. */
    public fun endStep(population: Population, time: Double, from: Int, to: Int)

    override fun endStep(population: Population, time: Double) {
        endStep(population, time, 0, population.size)
    }
}

/** What a sphere that moves through a face can hit within the step. */
public enum class ContactFaces {
    /** Nothing: there are no images beyond the face. */
    OPEN,

    /** The periodic images of the spheres on the other side. */
    PERIODIC,

    /** The face itself, which reflects it when its surface arrives there. */
    WALL,
}

/**
 * Images across the faces of [normalAxis] slide along [slideAxis]: the one at `+m` boxes is displaced by `m ·
 * offset(t)` and moves with `m · velocity` against its original.
 */
public class ImageShear(
    public val normalAxis: Int,
    public val slideAxis: Int,
    public val velocity: Double,
    private val slideLength: Double,
) {
    /**
     * Displacement of the image at +1 at [time], reduced to [0, length along the slide axis). A pure function of time.
     */
    public fun offset(time: Double): Double {
        val raw = (velocity * time) % slideLength
        return if (raw < 0) raw + slideLength else raw
    }

    /** Whole lengths of the box that [offset] leaves out: `velocity · time = turns · length + offset`. */
    public fun turns(time: Double): Double = Math.rint((velocity * time - offset(time)) / slideLength)
}
