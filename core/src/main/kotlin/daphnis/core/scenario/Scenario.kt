package daphnis.core.scenario

import daphnis.core.Engines
import daphnis.core.collision.GuardSpec
import daphnis.core.engine.EngineFactory
import daphnis.core.force.ForceSpec
import daphnis.core.initial.SizesSpec
import daphnis.core.initial.SpinsSpec
import daphnis.core.initial.VelocitiesSpec
import daphnis.core.input.Planet
import daphnis.core.input.UnitsSpec
import daphnis.core.merging.BreakingSpec
import daphnis.core.merging.MergingSpec
import daphnis.core.parallel.ThreadHandler
import daphnis.core.potential.BondsSpec
import daphnis.core.potential.InteractionSpec
import daphnis.core.search.SearchStructure
import daphnis.core.space.Space
import daphnis.core.surface.RestitutionSpec
import daphnis.core.surface.RoughnessSpec
import daphnis.core.swap.SwapsSpec
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/**
 * A simulation as a user writes it: a JSON file with comments and trailing commas allowed. `docs/scenario.md` explains
 * every key. [ResolvedScenario] is the scenario with all decisions made.
 *
 * Lengths, times and masses are in whatever units the author chose; [units] says how many cm/s one unit of speed is,
 * for restitution laws that were measured in cm/s.
 *
 * @property until time at which the run ends; when it is given, [untilOrbits] is ignored. One of the two is needed
 */
@OptIn(ExperimentalSerializationApi::class)
@Serializable
public data class Scenario @JvmOverloads constructor(
    override val name: String = "unnamed",
    override val description: String = "",
    override val seed: Long = 1,
    override val units: UnitsSpec = UnitsSpec(),
    override val frame: FrameSpec? = null,
    override val box: BoxSpec,
    override val boundary: BoundarySpec,
    override val particles: ParticlesSpec? = null,
    override val bodies: List<BodySpec> = emptyList(),
    override val placement: PlacementSpec = PlacementSpec.Random(),
    override val velocities: VelocitiesSpec? = null,
    override val restitution: RestitutionSpec,
    public val guard: GuardSpec? = null,
    override val forces: List<
        @Serializable(ForceKinds::class)
        ForceSpec,
        > = emptyList(),
    public val timeStep: TimeStepSpec = TimeStepSpec.Automatic(),
    public val until: Double? = null,
    public val untilOrbits: Double? = null,
    override val search: SearchStructure = SearchStructure.AUTO,
    override val engine: EngineSpec = EngineSpec(),
    override val output: OutputSpec = OutputSpec(),
    override val roughness: RoughnessSpec? = null,
    override val spins: SpinsSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val contacts: List<ContactSpec> = emptyList(),
    override val growth: GrowthSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val dimensions: Int = Space.VOLUME.dimensions,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val interaction: InteractionSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val merging: MergingSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val bonds: BondsSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val breaking: BreakingSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val swaps: SwapsSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val sources: List<SourceSpec> = emptyList(),
    /** From a [ResolvedScenario] that was written to a file; a new initial state has its own. */
    internal val firstBody: Int? = null,
) : ScenarioParts {
    /** [sources] with what they bring, also where that follows from [particles]. */
    internal val settledSources: List<SourceSpec> get() = sources.map { it.settled(particles) }

    /**
     * Id of the first of [bodies], or [Int.MAX_VALUE] without any: from this file of a run, or for an initial state of
     * [spheres] spheres.
     */
    public fun firstBody(spheres: Int): Int =
        if (bodies.isEmpty()) Int.MAX_VALUE else firstBody ?: (spheres - bodies.size)
}

/** @property lengths edges along x, y and, of three dimensions, z; the box is centred on the origin */
@Serializable
public class BoxSpec(public val lengths: List<Double>)

/**
 * Exactly one of [count], [fillingFactor], [opticalDepth] (Σ π r² per area of the x-y plane) and [surfaceDensity] (mass
 * per area). Masses come from [density] unless [mass] gives every sphere the same.
 *
 * Spheres of several [materials] have [sizes], [density] and [mass] there. Where these have counts, nothing else says how
 * many spheres there are.
 */
@Serializable
public class ParticlesSpec @JvmOverloads constructor(
    public val count: Int? = null,
    public val fillingFactor: Double? = null,
    public val opticalDepth: Double? = null,
    public val surfaceDensity: Double? = null,
    public val sizes: SizesSpec? = null,
    public val density: Double = 1.0,
    public val mass: Double? = null,
    public val materials: List<MaterialSpec>? = null,
)

/**
 * One large sphere, such as a moonlet, at [position]; other spheres are placed around it. Its mass is [mass], or
 * follows from [density]. It moves with the mean flow unless [velocity] is given. Its [material] may be one of the other
 * spheres' or one of its own.
 */
@Serializable
public class BodySpec @JvmOverloads constructor(
    public val radius: Double,
    public val position: List<Double>,
    public val density: Double? = null,
    public val mass: Double? = null,
    public val velocity: List<Double>? = null,
    public val material: String? = null,
)

@Serializable
public class EngineSpec @JvmOverloads constructor(public val name: String = "horizon", public val threads: Int = 0) {
    /**
     * Number of threads that make and check the initial state: that of the engine, which is one for the specification.
     */
    internal val threadsAtStart: Int get() = if (Engines.isSpecification(name)) {
        1
    } else {
        minOf(EngineFactory.threadsOrAll(threads), ThreadHandler.MOST)
    }
}
