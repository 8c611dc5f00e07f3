@file:JvmName("Boundaries")

package daphnis.core.boundary

import daphnis.core.population.Kinematics
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import daphnis.core.space.Images
import daphnis.core.space.Space
import daphnis.core.wall.WallSet

/**
 * What happens at the faces of the box. See [Box] for the axes.
 *
 * Along an axis with images every sphere is in the box when a step starts; otherwise the step is refused. Two moments
 * matter. **Within a step** spheres move on straight paths and may stick out of the box; [contactFaces] and
 * [shear] tell the contact search which images a sphere can hit, and walls reflect. **After the step** [endStep] brings
 * every sphere back. A boundary of your own needs only [box] and [endStep]; contacts are then searched only inside the
 * box. A boundary which repeats or has walls is a [PerSphereBoundary] and needs only [box] and [contactFaces], and the
 * [walls] where it has any.
 *
 * Code which needs to know how a boundary behaves uses these members and never its type, so a new boundary is one new
 * file.
 */
public interface BoundaryConditions : Kinematics {
    /** The box; infinite bounds on open axes. */
    public val box: Box

    /** Space in which particles move: the plane where the box is flat, which is then open along z. */
    override val space: Space get() = box.space

    /** What happens at the two faces across [axis] (0 = x, 1 = y, 2 = z). */
    public fun contactFaces(axis: Int): ContactFaces = ContactFaces.OPEN

    /** Whether a sphere can hit images beyond the faces across [axis]. Follows from [contactFaces]. */
    public fun hasImages(axis: Int): Boolean = contactFaces(axis) == ContactFaces.PERIODIC

    /**
     * Whether a sphere that leaves through a face across [axis] comes back through the other, whether or not there are
     * images to hit. Follows from [contactFaces].
     */
    public fun repeats(axis: Int): Boolean = hasImages(axis) || contactFaces(axis) == ContactFaces.WRAPPING

    /** How images slide relative to one another, or null when they are at rest. Both of its axes have images. */
    public val shear: ImageShear? get() = null

    /**
     * The rate at which images come nearer, per unit of time: the image m boxes of length L away is displaced by m L (1
     * − rate · s), where s is the time since the start of the step. 0, except within a step of a boundary in which
     * spheres grow; not with a [shear], which has an approach of its own.
     */
    public val approach: Double get() = 0.0

    /**
     * The mean flow that the boundary drives, or null when there is none. A granular temperature has to exclude it.
     */
    override val meanFlow: MeanFlow? get() = null

    /**
     * All walls. [contactFaces] is [ContactFaces.WALL] where two of them are faces of the box; the others are the same
     * everywhere along every axis that has images.
     */
    public val walls: WallSet get() = WallSet.NONE

    /** How radii change with time; null where they do not. */
    public val growth: Growth? get() = null

    /** Volume of the room, in the plane its area: that of the [box], less what other [walls] cut off at time 0. */
    public val volume: Double get() = box.volume

    /**
     * What this boundary is while spheres drift on straight paths from [start] over [duration]: [box] and offsets are
     * those at [start], images move by chords of their paths, and [endStep] puts spheres into the box at the end. With
     * a duration of 0 it is what this boundary is at that time, with the velocities that images have then. Null
     * where it is this one at all times; not where the box changes.
     */
    public fun during(start: Double, duration: Double): BoundaryConditions? = null

    /**
     * Brings [population] back into the box at the end of a step that ended at [time]: may change positions and
     * velocities and may remove spheres, but not radii, masses, ids or the order of those that stay. The result for
     * each sphere must depend only on its own state and [time], so that the array order cannot matter. A step that
     * fails may be done again, with the same [time]. A boundary that wraps reports it with [Population.addCrossing], so
     * that files can hold where a sphere has been.
     */
    public fun endStep(population: Population, time: Double)

    public companion object {
        /** [Open], the boundary that is none, for Java. */
        @JvmStatic
        public fun open(): BoundaryConditions = Open
    }
}

/** What this boundary is at [time], see [BoundaryConditions.during]. */
public fun BoundaryConditions.at(time: Double): BoundaryConditions = during(time, 0.0) ?: this

/** Whether the box changes with time. */
public val BoundaryConditions.isChanging: Boolean get() = during(0.0, 0.0) != null

/** The rate at which images across [axis] come nearer, see [BoundaryConditions.approach]. */
internal fun BoundaryConditions.approachAlong(axis: Int): Double =
    shear?.takeIf { it.normalAxis == axis }?.approach ?: approach

/** Whether images come nearer along any axis. */
internal val BoundaryConditions.imagesApproach: Boolean get() = approach != 0.0 || (shear?.approach ?: 0.0) != 0.0

/** Takes over the images of [boundary] at [time], the start of a step. */
public fun Images.prepare(boundary: BoundaryConditions, time: Double) {
    val box = boundary.box
    set({ if (boundary.hasImages(it)) box.length(it) else 0.0 }, boundary.approach)
    val shear = boundary.shear ?: return slide(-1, -1, 0.0, 0.0, 0.0)
    slide(shear.normalAxis, shear.slideAxis, shear.offset(time), shear.velocity, shear.velocityAcross)
}

/** What a sphere which moves through a face can hit within the step, and where it is after the step. */
public enum class ContactFaces {
    /** Nothing: there are no images beyond the face, and the sphere stays there. */
    OPEN,

    /** Nothing within the step: there are no images. After the step the sphere comes back through the other face. */
    WRAPPING,

    /** The periodic images of the spheres on the other side, where the sphere comes back after the step. */
    PERIODIC,

    /** The face itself, which reflects the sphere when its surface arrives there. */
    WALL,
}

/**
 * A boundary that brings spheres back one by one and removes none, so that engines with threads can process parts of a
 * population at the same time.
 */
public interface PerSphereBoundary : BoundaryConditions {
    /**
     * [endStep] for the indices [from] until [to]. Unless overridden, spheres are put back across every axis that
     * [repeats], first across sliding faces, where [shear] changes position and velocity as well.
     */
    public fun endStep(population: Population, time: Double, from: Int, to: Int) {
        val shear = shear
        shear?.wrap(population, time, from, to)
        for (axis in 0 until AXES) {
            if (repeats(axis) && axis != shear?.normalAxis) wrap(population, axis, box, from, to)
        }
    }

    /**
     * Whether [endStep] surely makes finite numbers of such as an epoch ends with, which are far from the ends of the
     * range of doubles. Anybody else's boundary may do anything, and images that slide do so with the time, which has
     * no bound.
     *
     * @param asked the boundary of the simulation: another one, if that hands on to this what it does not do itself
     */
    public fun keepsFinite(asked: PerSphereBoundary): Boolean = false

    override fun endStep(population: Population, time: Double) {
        endStep(population, time, 0, population.size)
    }
}

/** What spheres that grow while they collide say of themselves. */
public interface Growth {
    /** The reduced pressure P V/(N kT) in the last step; NaN where it cannot be known. */
    public val reducedPressure: Double

    /** The part of the box that the spheres of [population] fill; the same bits for any order of them. */
    public fun fillingFactor(population: Population): Double

    /** Takes over the [reducedPressure] from a run that went before. */
    public fun resume(reducedPressure: Double)
}

/** The volume of the room in [box], which is that of this boundary unless that is open. */
internal fun BoundaryConditions.roomIn(box: Box): Double = if (walls.surfaces.isEmpty()) box.volume else volume
