package daphnis.core.collision

import daphnis.core.api.EngineApi
import daphnis.core.surface.SurfaceContact

/**
 * Describes the last collision of two spheres. Filled by [CollisionLaw.collide], which itself keeps nothing. One object
 * per worker, reused for every collision.
 */
@EngineApi
public class CollisionOutcome {
    /** Normal component of the relative velocity at contact, > 0; at an edge ([isEdge]) < 0 where the two recede. */
    public var impactSpeed: Double = 0.0
        internal set

    /** Coefficient of restitution that the collision had; at an edge −1 times the ratio of velocities where it is passed. */
    public var coefficient: Double = 1.0
        internal set

    /**
     * Momentum that the second sphere received along the normal, ≥ 0, and of either sign at an edge. The first received
     * the opposite.
     */
    public var impulse: Double = 0.0
        internal set

    /** Momentum that the second sphere received along the surfaces; likewise [slideY], [slideZ]. 0 of smooth spheres. */
    internal var slideX = 0.0
    internal var slideY = 0.0
    internal var slideZ = 0.0

    /** Energy of motion and of spins that the surfaces took, beside what restitution takes. */
    internal var rubbed = 0.0

    /** Energy of the impact that is kept for the pieces of what breaks. */
    internal var kept = 0.0

    /** An impact begins that may change nothing. */
    internal fun begin(rank: Int) {
        impactSpeed = 0.0
        impulse = 0.0
        coefficient = 1.0
        edge = CONTACT
        gone = NOBODY
        forgetSurfaces()
        this.rank = rank
        separationX = 0.0
        separationY = 0.0
        separationZ = 0.0
    }

    /** As smooth spheres have it. */
    internal fun forgetSurfaces() {
        slideX = 0.0
        slideY = 0.0
        slideZ = 0.0
        rubbed = 0.0
    }

    /**
     * Vector from the centre of the first to the centre of the second sphere at contact; likewise [separationY],
     * [separationZ].
     */
    public var separationX: Double = 0.0
        internal set
    public var separationY: Double = 0.0
        internal set
    public var separationZ: Double = 0.0
        internal set

    /** Place among the collisions at the same time that led to this one, 1 for the first; see [StepRows.rank]. */
    public var rank: Int = 0
        internal set

    /** Where the two met: [CONTACT], or what happened at an edge, [IN], [OUT] or [BACK]. */
    internal var edge = CONTACT

    /** The slot of the sphere that is no more, since the two merged; [NOBODY] where they did not. */
    internal var gone = NOBODY

    /** Whether the two have merged, so that one of them is no more. */
    public val isMerger: Boolean get() = gone != NOBODY

    /** Whether this was no collision but an event at an edge of an interaction ([daphnis.core.potential.PairInteraction]). */
    public val isEdge: Boolean get() = edge != CONTACT

    /** At an edge: the velocities change by this times the separation, shared by the masses; whether the two recede then. */
    internal var factor = 0.0
    internal var outward = false

    /** What laws are asked about. */
    internal val contact = SurfaceContact()

    /** What walls say of the impact on them. */
    internal val wall = WallImpact()

    /** Relative velocity of the second sphere, its product with the separation, and the square of that. */
    internal var ux = 0.0
    internal var uy = 0.0
    internal var uz = 0.0
    internal var nearing = 0.0
    internal var distance2 = 1.0

    /** Of the angle by which axes have turned at the impact. */
    internal var cosine = 1.0
    internal var sine = 0.0

    /** Whether the guard made the collision elastic. */
    public var guarded: Boolean = false
        internal set

    internal companion object {
        const val NOBODY = -1

        /** Surfaces met. */
        const val CONTACT = 0

        /** The pair passed an edge on approach. */
        const val IN = 1

        /** It passed one as it receded. */
        const val OUT = 2

        /** It was turned back at an edge. */
        const val BACK = 3
    }
}
