package daphnis.core.format

import daphnis.core.population.SphereQuantity

/**
 * What the particles of a file are said to be made of: a word for each, such as the name of an element, a type of
 * LAMMPS, or a material. Which material of a scenario is meant, its author says.
 *
 * @param of place in [words] of the word of each particle, in the order of the state
 * @param numberedFrom the number that means the first material, in a file whose numbers are never names; null
 *   in others, where all words may be numbers from 0 on
 */
internal class Species(private val of: IntArray, private val words: List<String>, private val numberedFrom: Int? = null) {
    /** The one word of all particles where that tells nothing: the symbol of an element, or X, but none of [names]. */
    fun placeholder(names: List<String>): String? = words.singleOrNull()?.takeIf { it !in names && SYMBOL.matches(it) }

    /**
     * The number among [names] of the material of each particle. Words are names, or all of them are numbers.
     *
     * @throws FormatException for a word that is neither
     */
    fun numbers(names: List<String>): IntArray {
        val first = numberedFrom ?: 0
        val isNumbered =
            (numberedFrom != null || words.any { it !in names }) && words.all { it.toIntOrNull() != null }
        val numbers = IntArray(words.size) { k ->
            val word = words[k]
            val number = if (isNumbered) word.toInt() - first else names.indexOf(word)
            if (number !in names.indices) {
                val range = if (names.size == 1) "$first" else "$first to ${first + names.size - 1}"
                throw FormatException(
                    "particles of '${TextLines.shown(word)}' are of none of the materials ${names.joinToString()}, " +
                        "nor of a number $range",
                )
            }
            number
        }
        return IntArray(of.size) { numbers[of[it]] }
    }

    /** Words in the order in which they come up. */
    class Rows(size: Int) {
        private val of = IntArray(size)
        private val words = LinkedHashMap<String, Int>()

        /** [word] is that of particle [k]. */
        fun put(k: Int, word: String) {
            of[k] = words.getOrPut(word) { words.size }
        }

        /** Particle k of the result is the one at `order[k]`. */
        fun species(order: IntArray, numberedFrom: Int?): Species =
            Species(IntArray(order.size) { of[order[it]] }, words.keys.toList(), numberedFrom)
    }

    companion object {
        private val SYMBOL = Regex("[A-Z][a-z]?")

        /** The materials of the particles of a [snapshot] that has some. */
        fun of(snapshot: Snapshot): Species {
            val material = snapshot.material
            val names = snapshot.materials.ifEmpty { List(1 + (material.maxOrNull() ?: 0.0).toInt()) { "$it" } }
            return Species(IntArray(material.size) { material[it].toInt() }, names)
        }
    }
}

/** Quantities that files have as numbers in columns of their own. Of materials they have names, or types. */
internal val NUMBERED: List<SphereQuantity> = SphereQuantity.EXPORTED - SphereQuantity.MATERIAL
