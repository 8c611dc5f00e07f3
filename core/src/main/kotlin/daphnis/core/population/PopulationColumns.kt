package daphnis.core.population

import daphnis.core.population.SphereQuantity.Change.NEVER
import daphnis.core.population.SphereQuantity.Change.NOTED
import daphnis.core.population.SphereQuantity.Companion.NONE

/**
 * Columns of one length. A [Population] has two sets of them, which take turns: a step is written to one and leaves the
 * other as it was, so that the step can be taken back by changing a reference.
 *
 * @param numbers an array for each place, see [SphereQuantity]
 */
internal class PopulationColumns(
    private val numbers: Array<DoubleArray>,
    id: IntArray,
    override val bonds: Array<IntArray> = Bonds.NONE,
) : SphereColumns {
    /** An empty set for [size] spheres. */
    constructor(size: Int, optional: Int = 0) : this(
        Array(SphereQuantity.WIDTH) { if (isThere(it, optional)) DoubleArray(size) else NONE },
        IntArray(size),
        bonds(size, optional),
    )

    /** An empty set for [size] spheres that have what those of [other] have, with its notes of collisions. */
    constructor(size: Int, other: PopulationColumns) : this(
        Array(SphereQuantity.WIDTH) {
            if (it in NOTES) {
                other.numbers[it]
            } else if (isThere(it, other.optional)) {
                DoubleArray(size)
            } else {
                NONE
            }
        },
        IntArray(size),
        bonds(size, other.optional),
    )

    override val size: Int get() = numbers[0].size

    override fun column(place: Int): DoubleArray = numbers[place]

    override val id: IntArray get() = fixed.id

    /** What a step does not change: the same for both sets as long as spheres keep their order. */
    var fixed: FixedColumns = FixedColumns(Array(FIXED.size) { numbers[FIXED[it]] }, id)
        set(value) {
            for (k in FIXED.indices) numbers[FIXED[k]] = value.numbers[k]
            field = value
        }

    /** Takes over the notes of [other], for a step that does not write any. */
    fun shareNotes(other: PopulationColumns) {
        for (place in NOTES) numbers[place] = other.numbers[place]
    }

    /** Ensures notes that are not those of [other], for a step that writes them. */
    fun separateNotes(other: PopulationColumns) {
        for (place in NOTES) if (numbers[place] === other.numbers[place]) numbers[place] = DoubleArray(size)
    }

    /** Ensures notes of the right length that are those of no other set, with no collision in them. */
    fun ownNotes() {
        for (place in NOTES) numbers[place] = absent(place, size)
    }

    /** Copies all but positions to [to], which shares our [fixed]. */
    fun copyAllButPositionsInto(to: PopulationColumns) {
        for (place in KEPT) numbers[place].copyInto(to.numbers[place])
        bonds.copyInto(to.bonds)
        to.shareNotes(this)
    }

    /** Moves every sphere along its straight path to [to], which shares our [fixed]. */
    fun driftInto(to: PopulationColumns, duration: Double) {
        copyAllButPositionsInto(to)
        for (axis in 0..2) {
            val from = position(axis)
            val v = velocity(axis)
            val there = to.position(axis)
            for (k in 0 until size) there[k] = from[k] + v[k] * duration
        }
    }

    /** The same columns with [given] as those of [quantity]. */
    fun with(quantity: SphereQuantity, given: List<DoubleArray>): PopulationColumns = quantity.places.let { places ->
        PopulationColumns(
            Array(numbers.size) {
                if (it in
                    places
                ) {
                    given[it - places.first]
                } else {
                    numbers[it]
                }
            },
            id,
            bonds,
        )
    }

    /** The same columns with these [bonds]. */
    fun with(bonds: Array<IntArray>): PopulationColumns = PopulationColumns(numbers, id, bonds)

    /** The same columns, and such of 0 where spheres are to have the quantities of [optional] from now on. */
    fun having(optional: Int): PopulationColumns = PopulationColumns(
        Array(numbers.size) { place ->
            val isNew = numbers[place] === NONE && isThere(place, optional)
            if (isNew) DoubleArray(size) else numbers[place]
        },
        id,
        if (bonds === Bonds.NONE) bonds(size, optional) else bonds,
    )

    /** Copies all spheres to entries [at] and following of [to]. */
    fun copyInto(to: PopulationColumns, at: Int) {
        for (place in SphereQuantity.present(optional)) numbers[place].copyInto(to.numbers[place], at)
        id.copyInto(to.id, at)
        if (bonds !== Bonds.NONE) bonds.copyInto(to.bonds, at)
    }

    companion object {
        private fun isThere(place: Int, optional: Int) = SphereQuantity.at(place).isIn(optional)

        private fun bonds(size: Int, optional: Int) =
            if (optional and SphereQuantity.BONDED == 0) Bonds.NONE else Bonds.column(size)

        private val FIXED = SphereQuantity.places { it.change == NEVER }
        private val NOTES = SphereQuantity.places { it.change == NOTED }

        /** Columns of the set that a step without collisions copies. */
        private val KEPT = SphereQuantity.places {
            it != SphereQuantity.POSITION && it.change != NEVER && it.change != NOTED
        }

        /** The columns [given], which are the first, and others of which nothing is said. */
        fun of(given: Array<DoubleArray>, id: IntArray): PopulationColumns = PopulationColumns(
            Array(SphereQuantity.WIDTH) { given.getOrNull(it) ?: absent(it, given[0].size) },
            id,
        )

        /** A column of spheres of which nothing is said. */
        fun absent(place: Int, size: Int): DoubleArray = SphereQuantity.at(place).let { quantity ->
            if (quantity.isOptional) NONE else DoubleArray(size) { quantity.absent }
        }

        /** New columns of the [spheres] at the indices [kept]. */
        fun picked(spheres: SphereColumns, kept: IntArray): PopulationColumns = PopulationColumns(
            Array(SphereQuantity.WIDTH) { place ->
                val all = spheres.column(place)
                if (all === NONE) all else DoubleArray(kept.size) { all[kept[it]] }
            },
            IntArray(kept.size) { spheres.id[kept[it]] },
            if (spheres.bonds === Bonds.NONE) Bonds.NONE else Array(kept.size) { spheres.bonds[kept[it]] },
        )

        /**
         * New columns of the spheres of all [parts], one after the other. Where only some have spins or materials, those
         * of others are 0.
         *
         * @param optional the set of optional quantities that they have
         */
        fun joined(
            parts: List<SphereColumns>,
            optional: Int = parts.fold(0) { all, part -> all or part.optional },
        ): PopulationColumns {
            val all = PopulationColumns(parts.sumOf { it.size }, optional)
            var at = 0
            for (part in parts) {
                for (place in SphereQuantity.present(part.optional)) {
                    part.column(place).copyInto(all.numbers[place], at, 0, part.size)
                }
                part.id.copyInto(all.id, at, 0, part.size)
                if (part.bonds !== Bonds.NONE) part.bonds.copyInto(all.bonds, at, 0, part.size)
                at += part.size
            }
            return all
        }
    }
}

/** The columns of spheres that no step changes, in the order of their places, and the ids. */
internal class FixedColumns(val numbers: Array<DoubleArray>, val id: IntArray) {
    val size: Int get() = id.size

    /** The same columns with copies of the numbers. */
    fun withOwnNumbers(): FixedColumns =
        FixedColumns(Array(numbers.size) { numbers[it].let { own -> if (own === NONE) own else own.copyOf() } }, id)

    /** Columns of the same kind for [size] spheres. */
    fun empty(size: Int): FixedColumns =
        FixedColumns(Array(numbers.size) { if (numbers[it] === NONE) NONE else DoubleArray(size) }, IntArray(size))
}
