package daphnis.core.scenario

import daphnis.core.input.Nearest
import daphnis.core.input.ValueCheck
import daphnis.core.population.MaterialNames
import kotlin.math.abs

/**
 * Names and numbers of the materials of a [scenario], checked.
 *
 * @param given those of a state with which the scenario goes on, where it knows them
 */
internal class Materials(
    private val scenario: Scenario,
    private val check: ValueCheck,
    given: List<String> = emptyList(),
) {
    /** By number; empty where nothing is named. */
    val names: List<String> = scenario.materials.ifEmpty { given }

    init {
        scenario.particles?.materials?.let { ofParticles(it) }
        val file = scenario.placement.file
        file?.materials?.let { named ->
            check.must("placement.materials", named.isNotEmpty()) { "is empty; name one or leave it out" }
            named.forEachIndexed { k, name -> name("placement.materials[$k]", name, named.take(k)) }
        }
        scenario.bodies.forEachIndexed { k, body -> ofBody("bodies[$k].material", body.material, file != null) }
        check.must("particles.materials", names.size <= MaterialNames.MOST) {
            "and bodies have ${names.size} materials; there can be ${MaterialNames.MOST}"
        }
        check.must("particles.materials", given.isEmpty() || given == names) {
            "and bodies have materials $names; those of the spheres are $given"
        }
        contacts()
    }

    /** The number of the material of each body, of which none has one where nothing is named. */
    fun ofBodies(): IntArray = IntArray(scenario.bodies.size) { k ->
        scenario.bodies[k].material?.let { names.indexOf(it) } ?: 0
    }

    /** The numbers of the two materials of [contact]. */
    fun pair(contact: ContactSpec): Pair<Int, Int> =
        names.indexOf(contact.between[0]) to names.indexOf(contact.between[1])

    private fun name(key: String, name: String, before: List<String>) {
        MaterialNames.problem(name)?.let { check.fail(key, "is '${check.brief(name)}'; it $it") }
        check.must(key, name !in before) { "is '$name', which another material is called" }
    }

    private fun ofParticles(specs: List<MaterialSpec>) {
        val particles = scenario.particles!!
        check.must(KEY, specs.isNotEmpty()) { "is empty; name one or leave it out" }
        specs.forEachIndexed { k, spec -> name("$KEY[$k].name", spec.name, specs.take(k).map { it.name }) }
        val other = listOfNotNull(
            "sizes".takeIf { particles.sizes != null },
            "mass".takeIf { particles.mass != null },
            "density".takeIf { particles.density != 1.0 },
        ).firstOrNull()
        check.must("particles.$other", other == null) { "must be left out where there are materials, which have it" }
        val counts = specs.count { it.count != null }
        val isCounted = counts > 0
        specs.forEachIndexed { k, spec ->
            check.must("$KEY[$k]", (spec.count != null) == isCounted && (spec.share == null) == isCounted) {
                "needs a share or a count, one of the two, and the same one as the other materials"
            }
            spec.share?.let { share ->
                check.that("$KEY[$k].share", share, share > 0 && share <= 1) { "must be in (0, 1]" }
            }
            spec.count?.let { count -> check.that("$KEY[$k].count", count, count >= 1) { "must be at least 1" } }
        }
        if (isCounted) return
        val sum = specs.sumOf { it.share ?: 0.0 }
        check.must(KEY, abs(sum - 1) <= ROUNDING) { "have shares that add up to $sum; they must add up to 1" }
    }

    private fun ofBody(key: String, name: String?, isPlaced: Boolean) {
        if (name == null) {
            check.must(key, isPlaced || scenario.particles?.materials == null) {
                "is missing; give one of ${names.joinToString()}, or another, since spheres have materials"
            }
            return
        }
        name(key, name, emptyList())
        check.that(key, name, name in names) { "placement.materials has no such name" }
    }

    private fun contacts() {
        val seen = HashSet<Set<String>>()
        scenario.contacts.forEachIndexed { k, contact ->
            val key = "contacts[$k].between"
            val pair = contact.between
            check.must("contacts", names.isNotEmpty()) { "are between materials, of which none is named" }
            check.that(key, pair, pair.size == 2) { "must be the names of two materials, which may be the same" }
            for (name in pair) {
                check.must(key, name in names) {
                    "is '${check.brief(name)}'; ${Nearest.question(name, names)}known: ${names.joinToString()}"
                }
            }
            check.must(key, seen.add(pair.toSet())) { "names ${pair.joinToString()} a second time" }
            val says = listOfNotNull(contact.restitution, contact.roughness, contact.interaction)
            check.must("contacts[$k]", says.isNotEmpty()) {
                "says nothing; give restitution, roughness, interaction, or several"
            }
            check.must("contacts[$k].roughness.momentFactor", contact.roughness?.momentFactor == null) {
                "is that of all spheres; give it as roughness.momentFactor"
            }
        }
    }

    private companion object {
        const val KEY = "particles.materials"

        /** Of a sum of shares. */
        const val ROUNDING = 1e-9
    }
}
