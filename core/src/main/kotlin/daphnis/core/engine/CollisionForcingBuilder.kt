package daphnis.core.engine

import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.NoGuard
import daphnis.core.merging.BreakRule
import daphnis.core.merging.MergeRule
import daphnis.core.potential.PairInteractions
import daphnis.core.search.SearchStructure
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.Roughness
import daphnis.core.surface.SurfaceContact
import daphnis.core.swap.SwapRule

/**
 * The parts of a [CollisionForcing] by their names, from [CollisionForcing.builder]. A part that is given again
 * replaces the former one.
 *
 * ```java
 * CollisionForcing collisions = CollisionForcing.builder(speed -> 0.8)
 *     .guard(new FloorSpeedGuard(1e-6))
 *     .engine("islands", 2, Engines.factory())
 *     .build();
 * ```
 */
public class CollisionForcingBuilder internal constructor(private val law: ContactLaw) {
    private var guard: CollapseGuard = NoGuard
    private var makeEngine: () -> CollisionEngine = { SerialEngine() }
    private var recordCollisions = false
    private var search = SearchStructure.AUTO
    private var roughness: Roughness? = null
    private var momentFactor = SurfaceContact.SOLID
    private var interactions: PairInteractions? = null
    private var merging: MergeRule? = null
    private var breaking: BreakRule? = null
    private var swaps: SwapRule? = null

    /** What ends inelastic collapse; nothing unless given. */
    public fun guard(guard: CollapseGuard): CollisionForcingBuilder = apply { this.guard = guard }

    /** Computes collisions with [engine], which the forcing closes; the serial one unless given. */
    public fun engine(engine: CollisionEngine): CollisionForcingBuilder = apply { makeEngine = { engine } }

    /**
     * The engine that [engines] call [name], on [threads] threads; made by [build].
     *
     * @param threads 0 for one per core, see [daphnis.core.parallel.Cores]
     * @throws IllegalArgumentException when they do not know the name
     */
    public fun engine(name: String, threads: Int, engines: EngineFactory): CollisionForcingBuilder {
        require(name in engines.names) {
            "there is no engine '$name'; ${engines.successor(name) ?: "known: ${engines.names.joinToString()}"}"
        }
        return apply { makeEngine = { engines.create(name, threads)!! } }
    }

    /** Keeps the collisions of each step in [CollisionForcing.record], for outputs that read them. */
    public fun recordCollisions(): CollisionForcingBuilder = apply { recordCollisions = true }

    /** How neighbours are found; affects only the time it takes. */
    public fun search(search: SearchStructure): CollisionForcingBuilder = apply { this.search = search }

    /** Makes spheres rough, as nothing else than the law may; the population needs spins. */
    public fun roughness(roughness: Roughness): CollisionForcingBuilder = apply { this.roughness = roughness }

    /** Moment of inertia of spheres over mass · radius², > 0; 2/5 unless given. */
    public fun momentFactor(factor: Double): CollisionForcingBuilder = apply { momentFactor = factor }

    /** What spheres do to one another besides impacts; nothing unless given. */
    public fun interactions(interactions: PairInteractions): CollisionForcingBuilder =
        apply { this.interactions = interactions }

    /** Which impacts merge two spheres; none unless given. */
    public fun merging(rule: MergeRule): CollisionForcingBuilder = apply { merging = rule }

    /** Which impacts break spheres; none unless given. */
    public fun breaking(rule: BreakRule): CollisionForcingBuilder = apply { breaking = rule }

    /** How spheres swap places; they do not unless given. */
    public fun swaps(rule: SwapRule): CollisionForcingBuilder = apply { swaps = rule }

    /** The forcing; it is closed with the simulation. */
    public fun build(): CollisionForcing = CollisionForcing(
        law, guard, makeEngine(), recordCollisions, search, roughness, momentFactor, interactions, merging,
        breaking, swaps,
    )
}
