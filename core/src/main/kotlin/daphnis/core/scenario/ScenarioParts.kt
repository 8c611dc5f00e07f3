package daphnis.core.scenario

import daphnis.core.Clock
import daphnis.core.force.ForceSpec
import daphnis.core.initial.SpinsSpec
import daphnis.core.initial.VelocitiesSpec
import daphnis.core.input.UnitsSpec
import daphnis.core.merging.BreakingSpec
import daphnis.core.merging.MergingSpec
import daphnis.core.potential.BondsSpec
import daphnis.core.potential.InteractionSpec
import daphnis.core.search.SearchStructure
import daphnis.core.space.Space
import daphnis.core.surface.RestitutionSpec
import daphnis.core.surface.RoughnessSpec
import daphnis.core.swap.SwapsSpec

/** What a scenario as its author wrote it ([Scenario]) and as a run has it ([ResolvedScenario]) have in common. */
public interface ScenarioParts {
    public val name: String
    public val description: String
    public val seed: Long
    public val units: UnitsSpec
    public val frame: FrameSpec?
    public val box: BoxSpec
    public val boundary: BoundarySpec
    public val particles: ParticlesSpec?
    public val bodies: List<BodySpec>
    public val placement: PlacementSpec
    public val velocities: VelocitiesSpec?
    public val restitution: RestitutionSpec

    /** Surfaces of the spheres; null for smooth ones, which do not spin unless walls are rough. */
    public val roughness: RoughnessSpec?

    /** What spheres do to one another besides impacts; null for nothing. */
    public val interaction: InteractionSpec?

    /** Chains of spheres that are bound for good; null for none. */
    public val bonds: BondsSpec?

    /** Which impacts merge spheres; null for none. */
    public val merging: MergingSpec?

    /** Which impacts break spheres; null for none. */
    public val breaking: BreakingSpec?

    /** How often spheres swap places; null for spheres that do not. */
    public val swaps: SwapsSpec?

    /** Where spheres come and leave. */
    public val sources: List<SourceSpec>

    /** Spins at the start; null for none, or those of a file. */
    public val spins: SpinsSpec?

    /** What is different in contacts of certain materials. */
    public val contacts: List<ContactSpec>

    /** How spheres grow; null for spheres that do not. */
    public val growth: GrowthSpec?
    public val forces: List<ForceSpec>
    public val search: SearchStructure
    public val engine: EngineSpec
    public val output: OutputSpec

    /** 3, or 2 for discs in the plane z = 0. */
    public val dimensions: Int

    /** Space in which spheres move. */
    public val space: Space get() = Space.of(dimensions)

    /** Moment of inertia of the spheres over mass · radius². */
    public val momentFactor: Double get() = roughness?.momentFactor ?: space.momentFactor

    /** The unit of speed in cm/s; null where neither units nor laws of restitution, which are in cm/s, say what it is. */
    public val cmPerSecond: Double? get() = units.speedInCmPerSecond.takeIf {
        val laws = contacts.map { contact -> contact.restitution } + restitution
        units.lengthInMetres != null || it != 1.0 || laws.any { law -> law != null && law.constant == null }
    }

    /**
     * Names of the materials by number: of [particles], `particles` where these have none and a body has one, and then
     * those that only [bodies] have; of a state that is placed from a file those that the placement names. Empty where
     * nothing is named.
     */
    public val materials: List<String> get() {
        placement.file?.let { return it.materials.orEmpty() }
        val named = particles?.materials?.map { it.name }
        val ofBodies = bodies.mapNotNull { it.material }
        if (named == null && ofBodies.isEmpty()) return emptyList()
        return ((named ?: listOf(MaterialSpec.PARTICLES)) + ofBodies).distinct()
    }

    /**
     * What impacts of each pair of [materials] are like, each with its restitution, and null for smooth surfaces; one
     * entry between none where nothing is named.
     */
    public val impacts: List<ContactSpec> get() {
        val names = materials
        if (names.isEmpty()) return listOf(ContactSpec(emptyList(), restitution, roughness, interaction))
        return names.indices.flatMap { i ->
            (i until names.size).map { j ->
                val pair = listOf(names[i], names[j])
                val own = contacts.find { it.between.toSet() == pair.toSet() }
                ContactSpec(
                    pair,
                    own?.restitution ?: restitution,
                    own?.roughness ?: roughness,
                    own?.interaction ?: interaction,
                )
            }
        }
    }

    /**
     * The one constant coefficient of restitution of smooth spheres that meet each other, and nothing else, in a box at
     * rest that repeats, at least along some axes; null for other systems.
     */
    public val restitutionAtRest: Double? get() {
        val isAtRest = boundary.repeatsAtRest && frame == null && growth == null
        if (!isAtRest || forces.isNotEmpty() || bodies.isNotEmpty()) return null
        if (interactions.isNotEmpty() || merging != null || breaking != null || bonds != null) return null
        if (sources.isNotEmpty()) return null
        val coefficients = impacts.map { impact ->
            impact.restitution!!.constant?.takeIf { impact.roughness?.isSmooth != false }
        }
        return coefficients.distinct().singleOrNull()
    }

    /** All that spheres do to one another besides impacts. */
    public val interactions: List<InteractionSpec>
        get() = (listOfNotNull(interaction) + contacts.mapNotNull { it.interaction }).filter { !it.isNone }

    /** G in the scenario's units: that of a force that says it, else Newton's; null where neither is known. */
    public val gravitationalConstant: Double?
        get() = forces.firstNotNullOfOrNull { it.constant } ?: units.gravitationalConstant

    /** G of the gravity among all spheres; null without, and where it is not known. */
    public val selfGravity: Double?
        get() = forces.firstOrNull { it.isAmongAll }?.let { it.constant ?: units.gravitationalConstant }

    /** Time at which the run starts: that of the state from which it is placed, otherwise 0. */
    public val startTime: Double get() = placement.file?.time ?: 0.0

    /**
     * The clock of a run with [timeStep]: that of the run from which it starts, if its steps lead to [startTime] to the
     * bit, and otherwise one that begins there.
     */
    public fun clock(timeStep: TimeStepSpec): Clock {
        val kept = placement.file?.clock?.let { Clock(it.start, it.steps) }
        val isKept = timeStep.dt?.let { kept?.time(0, it) == startTime } == true
        return if (isKept) kept!! else Clock(startTime)
    }
}
