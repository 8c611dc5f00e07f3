package daphnis.core.scenario

import daphnis.core.input.ValueCheck
import daphnis.core.merging.BreakRule
import daphnis.core.merging.MergeRule
import daphnis.core.potential.PairInteractions
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.LawPlace
import daphnis.core.surface.MaterialLaws
import daphnis.core.surface.MaterialRoughness
import daphnis.core.surface.MeasuredSphere
import daphnis.core.surface.RestitutionSpec
import daphnis.core.surface.Roughness
import daphnis.core.swap.SwapRule

/** The laws of impacts in a [scenario], by pair of materials where it says so. */
internal class ContactLaws(
    private val scenario: Scenario,
    private val materials: Materials,
    private val check: ValueCheck,
) {
    /** ε; that of all spheres itself where no pair has another. */
    val restitution: ContactLaw

    /** What spheres do to one another besides impacts; null where nothing. */
    val interactions: PairInteractions?

    /** Which impacts merge spheres; null for none. */
    val mergeRule: MergeRule? = scenario.merging?.let { spec ->
        fun need(isMet: Boolean, what: String) = check.must("merging", isMet) { "needs $what" }
        need(!scenario.space.isPlane, "spheres in three dimensions, and these are discs")
        need(scenario.bodies.isEmpty(), "spheres without bodies")
        need(scenario.interactions.isEmpty() && scenario.bonds == null, "spheres without interaction and bonds")
        // What spins and orbits have together in a frame that turns is not kept by its axes alone.
        need(scenario.frame == null || !areRough(scenario), "smooth spheres in a frame that turns, without roughness")
        spec.rule("merging", scenario.gravitationalConstant, check)
    }

    /** Which impacts break spheres; null for none. */
    val breakRule: BreakRule? = scenario.breaking?.let { spec ->
        fun need(isMet: Boolean, what: String) = check.must("breaking", isMet) { "needs $what" }
        need(!scenario.space.isPlane, "spheres in three dimensions, and these are discs")
        need(scenario.bodies.isEmpty(), "spheres without bodies")
        need(scenario.interactions.isEmpty() && scenario.bonds == null, "spheres without interaction and bonds")
        need(scenario.spins == null && !areRough(scenario), "smooth spheres without spins")
        spec.rule("breaking", scenario.seed, check)
    }

    /** How spheres swap places; null for spheres that do not. */
    val swapRule: SwapRule? = scenario.swaps?.let { spec ->
        fun need(isMet: Boolean, what: String) = check.must("swaps", isMet) { "need $what" }
        need(scenario.bodies.isEmpty(), "spheres without bodies")
        need(scenario.interactions.isEmpty() && scenario.bonds == null, "spheres without interaction and bonds")
        need(scenario.merging == null && scenario.breaking == null, "spheres that neither merge nor break")
        need(scenario.forces.isEmpty(), "spheres on which no force acts")
        need(scenario.frame == null, "a frame that does not turn, and so no frame")
        spec.rule("swaps", scenario.seed, check)
    }

    /** β; null where no spheres are rough. */
    val roughness: Roughness?

    init {
        val particles = scenario.particles
        val all = law("restitution", scenario.restitution, isOfPair = false) {
            particles?.takeIf { it.materials == null }?.sizes?.radius?.let { MeasuredSphere(it) }
        }
        val surface = scenario.roughness?.law("roughness", check)
        var laws = MaterialLaws(all)
        var surfaces = MaterialRoughness(surface)
        var isRough = surface != null
        var pairs = scenario.interaction?.interaction("interaction", check)?.let { PairInteractions(it) }
        scenario.contacts.forEachIndexed { k, contact ->
            val (first, second) = materials.pair(contact)
            val key = "contacts[$k]"
            contact.restitution?.let {
                val its = "$key.restitution"
                laws = laws.between(first, second, law(its, it, isOfPair = true) { measured(contact, its) })
            }
            contact.interaction?.let { spec ->
                val interaction = spec.interaction("$key.interaction", check)
                pairs = (pairs ?: PairInteractions(null)).between(first, second, interaction)
            }
            contact.roughness?.let { spec ->
                val law = spec.law("$key.roughness", check)
                surfaces = surfaces.between(first, second, law)
                isRough = isRough || law != null
            }
        }
        restitution = if (scenario.contacts.any { it.restitution != null }) laws else all
        val chains = scenario.bonds?.chains(check)
        check.must("bonds", chains == null || scenario.bodies.isEmpty()) { "need spheres without bodies" }
        interactions = if (chains == null) pairs else (pairs ?: PairInteractions(null)).with(chains)
        roughness = when {
            !isRough -> null
            scenario.contacts.any { it.roughness != null } -> surfaces
            else -> surface
        }
    }

    private fun areRough(scenario: Scenario) =
        scenario.roughness != null || scenario.contacts.any { it.roughness != null }

    private fun law(
        key: String,
        spec: RestitutionSpec,
        isOfPair: Boolean,
        measured: () -> MeasuredSphere?,
    ): ContactLaw {
        val particles = scenario.particles?.takeIf { it.materials == null }
        fun mass(radius: Double) = particles?.mass ?: particles?.let { drawn(it.density, radius) }
        return spec.law(LawPlace(key, scenario.units.speedInCmPerSecond, check, isOfPair, ::mass, measured))
    }

    /** The mass of a sphere of [radius] and [density]. */
    private fun drawn(density: Double, radius: Double): Double {
        val space = scenario.space
        return density * space.volume(1.0) * radius * radius * if (space.isPlane) 1.0 else radius
    }

    /**
     * The sphere that stands for the two of [contact], of a law at [key] that names none. A law that depends on sizes
     * knows two spheres by their effective radius and mass alone, and two equal spheres with twice these have the same.
     */
    private fun measured(contact: ContactSpec, key: String): MeasuredSphere {
        val (first, second) = contact.between.map { name ->
            onlySphere(name) ?: check.fail(
                "$key.radius",
                "is missing; give that of two spheres that have the coefficient, since '$name' is not known to have " +
                    "one radius and one mass",
            )
        }
        return MeasuredSphere(2 * reduced(first.radius, second.radius), 2 * reduced(first.mass, second.mass))
    }

    private class One(val radius: Double, val mass: Double)

    private fun reduced(a: Double, b: Double) = if (a == b) a / 2 else a * b / (a + b)

    /** The sphere which all of the material [name] are like; null where they differ or come from a file. */
    private fun onlySphere(name: String): One? {
        val particles = scenario.particles ?: return null
        val kind = particles.materials?.find { it.name == name }
        val isOthers = particles.materials == null && name == MaterialSpec.PARTICLES
        val sizes = if (isOthers) particles.sizes else kind?.sizes
        val radius = sizes?.radius
        if (sizes != null && radius == null) return null
        val mass = if (isOthers) particles.mass else kind?.mass
        val drawn = radius?.let { One(it, mass ?: drawn(kind?.density ?: particles.density, it)) }
        val bodies = Bodies(scenario.bodies, particles, scenario.space, check)
        val numbers = materials.ofBodies()
        val all = numbers.indices.filter { materials.names[numbers[it]] == name }
            .map { One(bodies.radius[it], bodies.mass[it]) } + listOfNotNull(drawn)
        return all.firstOrNull()?.takeIf { one -> all.all { it.radius == one.radius && it.mass == one.mass } }
    }
}
