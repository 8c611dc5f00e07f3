package daphnis.core.population

/** What the columns of a population must be; [IllegalArgumentException] says what is wrong. */
internal object PopulationCheck {
    /** All [spheres] have all numbers of what they have, finite, and sizes that are positive. */
    fun columns(spheres: PopulationColumns) {
        val n = spheres.size
        for (place in SphereQuantity.present(spheres.optional)) {
            val size = spheres.column(place).size
            require(size == n) { "${nameOf(place)} has $size entries, x has $n" }
        }
        require(spheres.id.size == n) { "id has ${spheres.id.size} entries, x has $n" }
        for (quantity in SphereQuantity.EXPORTED) {
            if (quantity.isIn(spheres.optional)) for (place in quantity.places) check(spheres, quantity, place)
        }
    }

    /** The [ids] in ascending order, which are distinct and not negative. */
    fun sortedIds(ids: IntArray): IntArray {
        for (id in ids) require(id >= 0) { "id $id is negative; ids must be at least 0" }
        val sorted = ids.copyOf().apply { sort() }
        for (k in 1 until sorted.size) require(sorted[k] != sorted[k - 1]) { "id ${sorted[k]} occurs twice" }
        return sorted
    }

    /** Whatever [others] have [those] have too, so that they can be added. */
    fun mayJoin(those: Population, others: Population) {
        require(those.hasSpin || !others.hasSpin) { "spheres to be added have spins, those that are there none" }
        if (!others.hasMaterials) return
        require(those.hasMaterials) { "spheres to be added have materials, those that are there none" }
        require(others.materials == those.materials) {
            "materials of spheres to be added are ${others.materials}; they must be ${those.materials}, " +
                "as of those that are there"
        }
    }

    private fun check(spheres: PopulationColumns, quantity: SphereQuantity, place: Int) {
        val column = spheres.column(place)
        for (k in column.indices) {
            require(column[k].isFinite()) {
                "${nameOf(place)} of particle ${spheres.id[k]} is ${column[k]}; it must be finite"
            }
            require(!quantity.isPositive || column[k] > 0) {
                "${nameOf(place)} of particle ${spheres.id[k]} is ${column[k]}; it must be > 0"
            }
        }
    }

    private fun nameOf(place: Int) = SphereQuantity.at(place).let { it.columns[place - it.place] }
}
