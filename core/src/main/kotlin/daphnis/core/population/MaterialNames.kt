package daphnis.core.population

/** What names and numbers of materials may be. */
internal object MaterialNames {
    /** The most materials: a table has a number for each pair. */
    const val MOST: Int = 1000

    /** The most letters of a name: H5MD has room for as many of [MOST] names. */
    private const val LONGEST = 64
    private val WORD = Regex("[A-Za-z0-9_-]{1,$LONGEST}")

    /** What is wrong with [name], in words that follow it; null when it is a plain word, which every file can hold. */
    fun problem(name: String): String? =
        if (WORD.matches(name)) null else "must be a word of at most $LONGEST letters, digits, _ and -"

    /**
     * Checks that [names] are plain words, and that each of the [spheres] has the number of one.
     *
     * @throws IllegalArgumentException when not
     */
    fun check(spheres: SphereColumns, names: List<String>) {
        for (name in names) problem(name)?.let { throw IllegalArgumentException("material '$name' $it") }
        require(names.size <= MOST) { "there are ${names.size} materials; there can be $MOST" }
        require(names.distinct().size == names.size) { "a name of a material occurs twice in $names" }
        require(names.isEmpty() || spheres.hasMaterials) { "materials are named, but no sphere has one" }
        if (!spheres.hasMaterials) return
        val material = spheres.material
        // A part of a population that another node has is not told the names.
        val most = if (names.isEmpty()) MOST else names.size
        for (k in 0 until spheres.size) {
            val number = material[k]
            require(number >= 0 && number < most && number == Math.rint(number)) {
                "material of particle ${spheres.id[k]} is $number; it must be a whole number below $most"
            }
        }
    }
}
