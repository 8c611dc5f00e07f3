package daphnis.core.scenario

import daphnis.core.Engines
import daphnis.core.boundary.Space
import daphnis.core.engine.EngineFactory
import daphnis.core.hill.Epicycle
import daphnis.core.parallel.ThreadHandler
import daphnis.core.search.SearchStructure
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
    override val forces: List<ForceSpec> = emptyList(),
    public val timeStep: TimeStepSpec = TimeStepSpec.Automatic(),
    public val until: Double? = null,
    public val untilOrbits: Double? = null,
    override val search: SearchStructure = SearchStructure.AUTO,
    override val engine: EngineSpec = EngineSpec(),
    override val output: OutputSpec = OutputSpec(),
    override val roughness: RoughnessSpec? = null,
    override val spins: SpinsSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val contacts: List<ContactSpec> = emptyList(),
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val dimensions: Int = Space.VOLUME.dimensions,
    /** From a [ResolvedScenario] that was written to a file; a new initial state has its own. */
    internal val firstBody: Int? = null,
) : ScenarioParts {
    /**
     * Id of the first of [bodies], or [Int.MAX_VALUE] without any: from this file of a run, or for an initial state of
     * [spheres] spheres.
     */
    public fun firstBody(spheres: Int): Int =
        if (bodies.isEmpty()) Int.MAX_VALUE else firstBody ?: (spheres - bodies.size)
}

@Serializable
public sealed interface FrameSpec {
    /**
     * Hill's frame: exactly one of [angularSpeed], in radians per unit of time, and [distanceInKm] from the centre of
     * [planet].
     *
     * @property verticalFactor ν/Ω; when left out, 1 or what [oblateness] makes it
     * @property radialFactor κ/Ω; when left out, 1 or what [oblateness] makes it
     * @property gravitationalParameter GM in km³/s² in place of that of [planet]
     * @property oblateness of the planet, with [distanceInKm]; a point mass when left out
     */
    @Serializable
    @SerialName("hill")
    public class Hill @JvmOverloads constructor(
        public val angularSpeed: Double? = null,
        public val distanceInKm: Double? = null,
        public val planet: Planet = Planet.SATURN,
        public val verticalFactor: Double? = null,
        public val radialFactor: Double? = null,
        public val gravitationalParameter: Double? = null,
        public val oblateness: OblatenessSpec? = null,
    ) : FrameSpec
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
public sealed interface SizesSpec {
    @Serializable
    @SerialName("equal")
    public class Equal(public val radius: Double) : SizesSpec

    @Serializable
    @SerialName("power-law")
    public class PowerLaw(public val minimum: Double, public val maximum: Double, public val exponent: Double) :
        SizesSpec

    @Serializable
    @SerialName("log-normal")
    public class LogNormal(
        public val median: Double,
        public val sigma: Double,
        public val minimum: Double,
        public val maximum: Double,
    ) : SizesSpec

    @Serializable
    @SerialName("list")
    public class Listed(public val radii: List<Double>) : SizesSpec
}

@Serializable
public sealed interface GuardSpec {
    @Serializable
    @SerialName("none")
    public class None : GuardSpec

    /**
     * ε = 1 below an impact speed: exactly one of [speed], in units of speed, and [relative], in initial rms speeds.
     */
    @Serializable
    @SerialName("floor-speed")
    public class FloorSpeed @JvmOverloads constructor(
        public val speed: Double? = null,
        public val relative: Double? = null,
    ) : GuardSpec

    /** The TC rule: ε = 1 within [duration], in units of time, of a sphere's last collision. */
    @Serializable
    @SerialName("contact-duration")
    public class ContactDuration(public val duration: Double) : GuardSpec
}

@Serializable
public sealed interface ForceSpec {
    @Serializable
    @SerialName("uniform-acceleration")
    public class UniformAcceleration(public val acceleration: List<Double>) : ForceSpec

    /**
     * A moon on a given epicyclic orbit in Hill's frame. The ring feels its gravity; the moon feels no force.
     *
     * @property massRatio mass over that of the planet; exactly one of this and [mass]
     * @property x radial position of its guiding centre
     * @property y azimuthal position of its guiding centre at time 0
     * @property e amplitude of its epicycle in units of length: eccentricity times semi-major axis
     * @property phase φ at time 0 in radians; pericentre at 0
     * @property softening length ε in 1/(r² + ε²)
     * @property radius particles that touch it are removed; 0 for a point
     * @property constant G in the scenario's units, with [mass]; from [Scenario.units] when left out
     * @property inclination amplitude of its vertical swing in units of length: inclination times semi-major axis
     * @property node phase of that swing at time 0 in radians, from the ascending node
     * @property returns whether it comes back after each synodic period
     */
    @OptIn(ExperimentalSerializationApi::class)
    @Serializable
    @SerialName("satellite")
    public class Satellite @JvmOverloads constructor(
        public val massRatio: Double? = null,
        public val mass: Double? = null,
        public val x: Double,
        public val y: Double,
        public val e: Double = 0.0,
        public val phase: Double = 0.0,
        public val softening: Double = 0.0,
        public val radius: Double = 0.0,
        public val constant: Double? = null,
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val inclination: Double = 0.0,
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val node: Double = 0.0,
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val returns: Boolean = false,
    ) : ForceSpec {
        /** Its epicycle at time 0; without [inclination] the vertical phase is 0. */
        public val orbit: Epicycle
            get() = Epicycle(x, y, e, phase, inclination, if (inclination == 0.0) 0.0 else node - Math.PI / 2)
    }

    /**
     * Gravity between the particles.
     *
     * @property openingAngle a node of a tree is taken as one mass when its size is below this times its distance
     * @property softening length ε in 1/(r² + ε²); 0 with modes
     * @property images the range of a tree around each particle is [images] + ½ of the shortest periodic edge
     * @property constant G in the scenario's units; from [Scenario.units] when left out
     * @property spacing between points of a mesh; about one point in the plane per sphere when left out
     * @property modes how many radial waves, with [GravityMethod.RADIAL_MODES] alone
     */
    @Serializable
    @SerialName("self-gravity")
    public class SelfGravity @JvmOverloads constructor(
        public val openingAngle: Double = 0.5,
        public val softening: Double = 0.0,
        public val images: Int = 1,
        public val constant: Double? = null,
        public val method: GravityMethod = GravityMethod.TREE,
        public val spacing: Double? = null,
        public val modes: Int? = null,
    ) : ForceSpec

    /**
     * Gravity of [Scenario.bodies] on all other spheres and, as reaction, of these on the bodies, but not among the
     * other spheres. Nearest images count.
     */
    @Serializable
    @SerialName("body-gravity")
    public class BodyGravity @JvmOverloads constructor(
        public val softening: Double = 0.0,
        public val constant: Double? = null,
    ) : ForceSpec
}

@Serializable
public sealed interface TimeStepSpec {
    /**
     * Chosen from the state, where no force acts; see [FreePath]. Intervals of outputs and the end are hit exactly.
     *
     * @property path how far the fastest sphere moves in a step at most, a length; null for one that follows from
     *   the initial state
     */
    @Serializable
    @SerialName("automatic")
    public class Automatic @JvmOverloads constructor(public val path: Double? = null) : TimeStepSpec

    @Serializable
    @SerialName("fixed")
    public class Fixed(public val dt: Double) : TimeStepSpec

    /** [steps] equal steps per orbit of the frame. */
    @Serializable
    @SerialName("orbit-fraction")
    public class OrbitFraction(public val steps: Double) : TimeStepSpec

    /**
     * The fastest sphere crosses at most [fraction] of [cell] (default: mean distance between spheres); never longer
     * than [longest].
     */
    @Serializable
    @SerialName("cell-crossing")
    public class CellCrossing @JvmOverloads constructor(
        public val fraction: Double = 0.5,
        public val cell: Double? = null,
        public val longest: Double,
    ) : TimeStepSpec
}

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
