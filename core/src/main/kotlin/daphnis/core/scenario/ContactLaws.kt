package daphnis.core.scenario

import daphnis.core.surface.ContactLaw
import daphnis.core.surface.MaterialLaws
import daphnis.core.surface.MaterialRoughness
import daphnis.core.surface.Roughness

/** The laws of impacts in a [scenario], by pair of materials where it says so. */
internal class ContactLaws(private val scenario: Scenario, private val materials: Materials, check: ValueCheck) {
    /** ε; that of all spheres itself where no pair has another. */
    val restitution: ContactLaw

    /** β; null where no spheres are rough. */
    val roughness: Roughness?

    init {
        val all = scenario.restitution.law(scenario, check)
        val surface = scenario.roughness?.law("roughness", check)
        var laws = MaterialLaws(all)
        var surfaces = MaterialRoughness(surface)
        var isRough = surface != null
        scenario.contacts.forEachIndexed { k, contact ->
            val (first, second) = materials.pair(contact)
            val key = "contacts[$k]"
            contact.restitution?.let {
                laws = laws.between(first, second, it.law(scenario, check, "$key.restitution"))
            }
            contact.roughness?.let { spec ->
                val law = spec.law("$key.roughness", check)
                surfaces = surfaces.between(first, second, law)
                isRough = isRough || law != null
            }
        }
        restitution = if (scenario.contacts.any { it.restitution != null }) laws else all
        roughness = when {
            !isRough -> null
            scenario.contacts.any { it.roughness != null } -> surfaces
            else -> surface
        }
    }
}
