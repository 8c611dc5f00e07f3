package daphnis.analysis.plot

import daphnis.analysis.insitu.State

/**
 * What is told apart in pictures of a [state] by colour: particles of each material, and bodies, such as moonlets.
 * Colours are told apart by the colour-blind, after Okabe & Ito.
 */
internal class SphereKinds(private val state: State) {
    private val p = state.population

    /** Numbers of the materials of particles, where there are several. */
    private val materials = if (!p.hasMaterials) {
        emptyList()
    } else {
        (0 until p.size).filter(state::isParticle).map { p.material[it].toInt() }.distinct().sorted()
    }.takeIf { it.size > 1 }.orEmpty()
    private val hasBodies = (0 until p.size).any { !state.isParticle(it) }

    /** Names by number; none where all spheres are of one kind. */
    val names: List<String> = when {
        materials.isEmpty() && !hasBodies -> emptyList()
        else -> materials.map { p.materials[it] }.ifEmpty { listOf("particles") } +
            if (!hasBodies) emptyList() else listOf(if (state.omega == null) "bodies" else "moonlets")
    }

    /** Number of the kind of the sphere at [index]. */
    fun of(index: Int): Int = when {
        !state.isParticle(index) -> names.lastIndex
        materials.isEmpty() -> 0
        else -> materials.indexOf(p.material[index].toInt())
    }

    /** The brightest colour of [kind]. */
    fun colour(kind: Int): String = when {
        hasBodies && kind == names.lastIndex -> BODY
        else -> COLOURS[kind % COLOURS.size]
    }

    private companion object {
        const val BODY = "#e8632c"
        val COLOURS = listOf("#ede3cc", "#56b4e9", "#d98cb8", "#3fbf95", "#f0e442", "#8f8fd8")
    }
}
