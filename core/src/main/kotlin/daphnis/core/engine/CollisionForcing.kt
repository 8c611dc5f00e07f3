package daphnis.core.engine

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.Merging
import daphnis.core.collision.NoGuard
import daphnis.core.collision.PairStates
import daphnis.core.merging.BreakRule
import daphnis.core.merging.MergeRule
import daphnis.core.merging.Pieces
import daphnis.core.population.Bonds
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.potential.PairInteractions
import daphnis.core.search.Overlap
import daphnis.core.search.Reach
import daphnis.core.search.SearchStructure
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.Restitution
import daphnis.core.surface.Roughness
import daphnis.core.surface.SurfaceContact
import daphnis.core.swap.SwapMoves
import daphnis.core.swap.SwapRule

/**
 * The collisional forcing: moves the population through a step with every collision in time order.
 *
 * @param law of both coefficients of an impact; a [Restitution] for smooth spheres
 * @property engine moves the spheres; not asked in a run whose steps nodes compute
 * @param search how neighbours are found; affects only the time it takes
 * @param recordCollisions whether the collisions of each step are kept in [record] for outputs
 * @param roughness what surfaces do to one another in a collision, in place of what [law] says; null for the law's
 * @param momentFactor moment of inertia of spheres over mass · radius²
 * @param interactions what spheres do to one another besides impacts; null for nothing
 * @param mergeRule which impacts merge two spheres; null for none
 * @param breakRule which impacts break spheres; null for none
 * @param swapRule how spheres swap places; null for spheres that do not
 */
public class CollisionForcing @JvmOverloads constructor(
    law: ContactLaw,
    guard: CollapseGuard = NoGuard,
    public val engine: CollisionEngine = SerialEngine(),
    recordCollisions: Boolean = false,
    private val search: SearchStructure = SearchStructure.AUTO,
    roughness: Roughness? = null,
    internal val momentFactor: Double = SurfaceContact.SOLID,
    interactions: PairInteractions? = null,
    mergeRule: MergeRule? = null,
    breakRule: BreakRule? = null,
    swapRule: SwapRule? = null,
) : AutoCloseable {
    private var collisionLaw = CollisionLaw(
        law,
        guard,
        roughness,
        momentFactor,
        interactions = interactions,
        mergeRule = mergeRule,
        breakRule = breakRule,
    )
    private val pieces = breakRule?.let { Pieces(it) }
    private val swaps = swapRule?.let { SwapMoves(it) }
    private var step: CollisionStep? = null

    init {
        require(swaps == null || collisionLaw.isPlain) { "spheres swap places; they can only meet then" }
    }

    /** See [daphnis.core.force.Drift.turning]; to be set before the first step. */
    internal var turning = 0.0
        set(value) {
            field = value
            renewLaw()
        }

    /**
     * The part of the acceleration of spheres between collisions that is the same for all, along x, y, z; to be set
     * before the first step.
     */
    internal var acceleration = listOf(0.0, 0.0, 0.0)
        set(value) {
            field = value
            renewLaw()
        }

    private fun renewLaw() {
        val law = collisionLaw
        collisionLaw =
            CollisionLaw(
                law.contactLaw,
                law.guard,
                null,
                momentFactor,
                turning,
                acceleration,
                law.interactions,
                law.mergeRule,
                law.breakRule,
            )
        step = null
    }

    /** See [CollisionStep.toCome]. */
    internal var toCome = CollisionStep.UNKNOWN

    /** Whether the next step is the first of spheres of which nobody has seen that they do not overlap. */
    internal var isStartUnchecked = false

    /** What has been counted since the start of the run. */
    public val counters: CollisionCounters = CollisionCounters()

    /** The collisions of the last step, in order; empty after a step that failed; null when they are not kept. */
    public val record: CollisionRecord? = if (recordCollisions) CollisionRecord() else null

    /** Sums over the collisions of the last step, where nodes give these in place of the record. */
    internal var tally: StepTally? = null

    /**
     * Moves [population] from [start] over [duration]; applying boundaries at the end is the caller's task. See
     * [CollisionEngine.advance].
     *
     * @throws IllegalArgumentException also when spheres or walls are rough and the population has no spins, or when
     *   the moment of inertia is more than that of a hollow sphere or, in the plane, of a ring, or when a sphere that
     *   has merged touches its own image
     */
    public fun advance(population: Population, boundary: BoundaryConditions, start: Double, duration: Double) {
        val step = step.takeIf { it != null && it.population === population && it.boundary === boundary }
            ?: newStep(population, boundary, start).also { step = it }
        if (isStartUnchecked) {
            // What no engine takes is refused first, as they do it: pairs are not searched for among such spheres.
            Reach().measure(population, boundary, duration)
            checkStart(population, boundary, start)
        }
        step.start = start
        step.duration = duration
        step.record = record
        step.toCome = toCome
        engine.advance(step)
        if (collisionLaw.merging != null) {
            Merging.removeGone(population)
            requireRoom(population, boundary)
        }
    }

    /**
     * Puts pieces in the places of the spheres of [population], and of those of [partition], that broke in the step from
     * [start].
     */
    internal fun scatter(population: Population, partition: Partition, start: Double) {
        if (pieces != null) counters.broken += pieces.scatter(population, partition, start)
    }

    /** Swaps places of the spheres of [population], and of those of [partition], in the step from [start] to [end]. */
    internal fun swap(
        population: Population,
        boundary: BoundaryConditions,
        partition: Partition,
        start: Double,
        end: Double,
    ) {
        swaps?.carryOut(population, boundary, partition, start, end, counters)
    }

    /** See [CollisionLaw.isPlain]. */
    internal val isPlain: Boolean get() = collisionLaw.isPlain

    /** The states of pairs; null without interactions. */
    internal val states: PairStates? get() = collisionLaw.edges?.states

    /**
     * Gives the pairs of [population] their states at [time], unless they have any.
     *
     * @throws IllegalArgumentException for spheres with which no step can begin
     */
    internal fun bind(population: Population, boundary: BoundaryConditions, time: Double) {
        if (population.bonds !== Bonds.NONE && !Bonds.areSaid(population.bonds)) return
        if (pieces != null) population.bind(Bonds.column(population.size))
        val states = states ?: return
        val then = boundary.at(time)
        Reach().measure(population, then, SHORT)
        states.bind(population, then, time)
    }

    /** Requires that no sphere that has grown by mergers touches its own image. */
    private fun requireRoom(population: Population, boundary: BoundaryConditions) {
        val largest = population.radius.maxOrNull() ?: return
        for (axis in 0..2) {
            require(!boundary.hasImages(axis) || 2 * largest < boundary.box.length(axis)) { Merging.OWN_IMAGE }
        }
    }

    private fun newStep(population: Population, boundary: BoundaryConditions, time: Double): CollisionStep {
        val isRough = collisionLaw.isRough || boundary.walls.any { it.roughness != null }
        require(!isRough || population.hasSpin) {
            "spheres or walls are rough, and the population has no angular velocities; give them, such as 0 for all"
        }
        collisionLaw.requireIn(boundary.space)
        require(swaps == null || boundary.meanFlow == null) { "spheres swap places; they cannot in a mean flow" }
        require(pieces == null || !population.hasSpin) { "spheres break and have spins; pieces would not keep them" }
        bind(population, boundary, time)
        return CollisionStep(population, boundary, collisionLaw, counters, search)
    }

    /** @throws IllegalArgumentException when spheres overlap at the time [start] */
    internal fun checkStart(population: Population, boundary: BoundaryConditions, start: Double) {
        if (isStartUnchecked && !collisionLaw.mayOverlap) Overlap.requireNone(population, boundary, start)
        isStartUnchecked = false
    }

    override fun close() {
        engine.close()
    }

    public companion object {
        /** No sphere goes anywhere in a step of this length. */
        private const val SHORT = 1e-30

        /** Names the parts of a forcing with the law [restitution] one by one. */
        @JvmStatic
        public fun builder(restitution: Restitution): CollisionForcingBuilder = CollisionForcingBuilder(restitution)

        /** The same with a [law] of both coefficients. */
        @JvmStatic
        public fun builder(law: ContactLaw): CollisionForcingBuilder = CollisionForcingBuilder(law)
    }
}
