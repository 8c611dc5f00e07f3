package daphnis.core.scenario

import daphnis.core.Engines
import daphnis.core.collision.GuardSpec
import daphnis.core.engine.EngineFactory
import daphnis.core.force.ForceSpec
import daphnis.core.initial.SizesSpec
import daphnis.core.initial.SpinsSpec
import daphnis.core.initial.VelocitiesSpec
import daphnis.core.input.Described
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
    @Described("text for the reader, which also names the run directory; default `unnamed`")
    override val name: String = "unnamed",
    @Described("text for the reader; default empty")
    override val description: String = "",
    @Described(
        "seed of the initial state; sizes, places, velocities and spins each have a random stream of their own; " +
            "default 1",
    )
    override val seed: Long = 1,
    @Described("what one unit of length, mass and speed is; default unknown")
    override val units: UnitsSpec = UnitsSpec(),
    @Described("the frame that turns with the orbit; default none")
    override val frame: FrameSpec? = null,
    @Described("the space, centred on the origin")
    override val box: BoxSpec,
    @Described("what happens at the faces of the box")
    override val boundary: BoundarySpec,
    @Described("how many spheres, and of what sizes and masses; needed unless they are placed from a file")
    override val particles: ParticlesSpec? = null,
    @Described("large spheres, such as moonlets, around which all others are placed; default none")
    override val bodies: List<BodySpec> = emptyList(),
    @Described("where spheres are at the start; default `random`")
    override val placement: PlacementSpec = PlacementSpec.Random(),
    @Described("velocities at the start; needed unless spheres are placed from a file")
    override val velocities: VelocitiesSpec? = null,
    @Described("the coefficient of restitution of impacts")
    override val restitution: RestitutionSpec,
    @Described(
        "what keeps off inelastic collapse; default `floor-speed` with `relative` 1e-6 where slow impacts are " +
            "inelastic, else `none`",
    )
    public val guard: GuardSpec? = null,
    @Described("what acts besides impacts; default none")
    override val forces: List<
        @Serializable(ForceKinds::class)
        ForceSpec,
        > = emptyList(),
    @Described("how long steps are; needed with a force or a frame; default `automatic`")
    public val timeStep: TimeStepSpec = TimeStepSpec.Automatic(),
    @Described("time at which the run ends; one of this and `untilOrbits` is needed, and this wins if a file has both")
    public val until: Double? = null,
    @Described("the same in orbits of the frame, which must be given")
    public val untilOrbits: Double? = null,
    @Described(
        "how neighbours are found: `grid`, one regular grid; `tree`, a level of cells for each class of sizes; " +
            "`auto`, whichever should test fewer pairs; default `auto`",
    )
    override val search: SearchStructure = SearchStructure.AUTO,
    @Described("which engine computes, on how many threads; no bit depends on it; default `horizon` on all threads")
    override val engine: EngineSpec = EngineSpec(),
    @Described("how often files are written; default a row of `series.csv` per step")
    override val output: OutputSpec = OutputSpec(),
    @Described("surfaces of the spheres, which make them spin; default smooth, without spin")
    override val roughness: RoughnessSpec? = null,
    @Described("angular velocities at the start; default zero, or those of a file")
    override val spins: SpinsSpec? = null,
    @Described("laws of impacts between certain materials; default none: all impacts have the same laws")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val contacts: List<ContactSpec> = emptyList(),
    @Described("spheres that grow; default none")
    override val growth: GrowthSpec? = null,
    @Described("3, or 2 for discs in the plane z = 0; default 3")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val dimensions: Int = Space.VOLUME.dimensions,
    @Described("wells, shoulders and bridges beside impacts; default none")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val interaction: InteractionSpec? = null,
    @Described("which impacts make one sphere of two; default none")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val merging: MergingSpec? = null,
    @Described("spheres tied to chains; default none")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val bonds: BondsSpec? = null,
    @Described("which impacts break spheres, and into what; default none")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val breaking: BreakingSpec? = null,
    @Described("how often spheres swap places; default never")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val swaps: SwapsSpec? = null,
    @Described("where spheres come and leave, in the order in which they act; default none")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val sources: List<SourceSpec> = emptyList(),
    /** From a [ResolvedScenario] that was written to a file; a new initial state has its own. */
    @Described("written by a run: the id of the first of `bodies`; leave it out")
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
public class BoxSpec(
    @Described("edges along x, y, z, of discs along x and y; 1e-70 to 1e70")
    public val lengths: List<Double>,
)

/**
 * Exactly one of [count], [fillingFactor], [opticalDepth] (Σ π r² per area of the x-y plane) and [surfaceDensity] (mass
 * per area). Masses come from [density] unless [mass] gives every sphere the same.
 *
 * Spheres of several [materials] have [sizes], [density] and [mass] there. Where these have counts, nothing else says how
 * many spheres there are.
 */
@Serializable
public class ParticlesSpec @JvmOverloads constructor(
    @Described("number of spheres; one of this and the next three, or none where all materials have counts")
    public val count: Int? = null,
    @Described("volume of the spheres over that of the room; of discs area")
    public val fillingFactor: Double? = null,
    @Described("Σ π r² per area of the x-y plane")
    public val opticalDepth: Double? = null,
    @Described("mass per area of the x-y plane")
    public val surfaceDensity: Double? = null,
    @Described("distribution of radii; of this and `materials` exactly one")
    public val sizes: SizesSpec? = null,
    @Described("mass per volume of a sphere; default 1")
    public val density: Double = 1.0,
    @Described("the same mass for every sphere, in place of `density`; default by `density`")
    public val mass: Double? = null,
    @Described("kinds of spheres, which have `sizes`, `density` and `mass` themselves; default none")
    public val materials: List<MaterialSpec>? = null,
)

/**
 * One large sphere, such as a moonlet, at [position]; other spheres are placed around it. Its mass is [mass], or
 * follows from [density]. It moves with the mean flow unless [velocity] is given. Its [material] may be one of the other
 * spheres' or one of its own.
 */
@Serializable
public class BodySpec @JvmOverloads constructor(
    @Described("a length")
    public val radius: Double,
    @Described("x, y, z of the centre")
    public val position: List<Double>,
    @Described("mass per volume; default that of the particles, or of its material where they have materials")
    public val density: Double? = null,
    @Described("in place of `density`; default by `density`")
    public val mass: Double? = null,
    @Described("three numbers; default that of the mean flow")
    public val velocity: List<Double>? = null,
    @Described(
        "one of those of the particles or a name of its own; needed where particles have materials; default none",
    )
    public val material: String? = null,
)

@Serializable
public class EngineSpec @JvmOverloads constructor(
    @Described(
        "collision engine: `horizon`, `islands`, `thread-pool`, `actors`, `pekko` or `serial`; default `horizon`",
    )
    public val name: String = "horizon",
    @Described("number of threads; 0 is one per core of the job; with few spheres some may sleep; default 0")
    public val threads: Int = 0,
) {
    /**
     * Number of threads that make and check the initial state: that of the engine, which is one for the specification.
     */
    internal val threadsAtStart: Int get() = if (Engines.isSpecification(name)) {
        1
    } else {
        minOf(EngineFactory.threadsOrAll(threads), ThreadHandler.MOST)
    }
}
