package daphnis.core.potential

/**
 * What two spheres do to one another besides the impact of their surfaces. Between certain distances, the **edges**,
 * nothing happens, so paths stay straight, and at an edge momentum is exchanged along the line of centres: an event
 * like a contact. Distances are given over the sum of the two radii, so that 1 is contact. Immutable.
 *
 * A pair is in one of a few **states**. A state has an inner edge, met when the two approach, and an outer one, met
 * when they recede, and says what each costs: if the kinetic energy of their motion along the line of centres, ½ μ v_n²,
 * is enough, the pair passes into another state, else v_n is reversed. A pair that is far away is in state 0.
 */
public abstract class PairInteraction internal constructor() {
    /** From that of a pair which is far away, which has no outer edge. */
    internal abstract val states: List<PairState>

    /** The largest distance of an edge. */
    public val reach: Double get() = states.maxOf { maxOf(it.inner?.ratio ?: 0.0, it.outer?.ratio ?: 0.0) }

    /** The largest distance of an edge which takes kinetic energy to leave; 0 where the two do not attract each other. */
    public val attractiveReach: Double
        get() = states.maxOf { state -> state.outer?.takeIf { it.cost > 0 }?.ratio ?: 0.0 }

    /** Whether spheres cannot pass through one another. */
    public val isHard: Boolean
        get() = states.any { it.inner?.isContact == true || it.inner?.cost == Double.POSITIVE_INFINITY }
}

/**
 * A state of a pair.
 *
 * @property energy potential energy
 * @property inner edge that is met on approach; null where there is none
 * @property outer edge that is met when the two recede; null where there is none
 * @property size how what the outer edge costs goes with sizes; null for the same of all
 */
internal class PairState(val energy: Double, val inner: Edge?, val outer: Edge?, val size: SizeLaw? = null)

/** A factor that is 1 for the effective radius [radius] and goes with the power [exponent] of it. */
internal class SizeLaw(private val radius: Double, private val exponent: Double) {
    /** The factor for spheres of the radii [first] and [second]. */
    fun factor(first: Double, second: Double): Double =
        StrictMath.pow(first * second / (first + second) / radius, exponent)
}

/**
 * An edge of a [PairState].
 *
 * @property ratio distance over the sum of the radii
 * @property next number of the state beyond it
 * @property cost kinetic energy that passing it takes, below 0 where it gives some; ∞ where nothing passes
 * @property isContact whether surfaces meet here, and the contact law says what happens; [next] is the state after that
 */
internal class Edge(val ratio: Double, val next: Int, val cost: Double, val isContact: Boolean = false) {
    companion object {
        /** Where surfaces meet, in a pair that is in state [next] after it. */
        fun contact(next: Int): Edge = Edge(1.0, next, 0.0, isContact = true)
    }
}
