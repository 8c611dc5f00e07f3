package daphnis.core.population

/**
 * What pairs remember of their past, beside the states of their spheres: the states of pairs that are inside a stepped
 * potential, bridged or tied. Each sphere has a list of its partners, by ascending id, each followed by the state of the
 * pair, a number from 1 on: `[id, state, id, state, …]`. Both spheres of a pair have it in their lists. Lists are not
 * changed but replaced, so that copies of rows, and sets of columns that take turns, share them.
 */
internal object Bonds {
    /** The column of spheres whose pairs remember nothing. There is no other of it, so it is known by reference. */
    @JvmField
    val NONE: Array<IntArray> = emptyArray()

    /** The list of a sphere without partners. */
    @JvmField
    val FREE: IntArray = IntArray(0)

    /** The state of a pair that is in no list. */
    const val UNBOUND: Int = 0

    /** The state of a pair of which a file says that it has one, and not which, see [of]. */
    const val SAID: Int = Int.MAX_VALUE

    /** The partners in [pairs], lower and higher id of each, of the spheres [ids]; all of them are [SAID] to be. */
    fun of(ids: IntArray, pairs: IntArray): Array<IntArray> = column(
        ids,
        IntArray(pairs.size / 2 * PAIR) { if (it % PAIR == 2) SAID else pairs[it / PAIR * 2 + it % PAIR] },
    )

    /** Whether [lists] are [of] a file. */
    fun areSaid(lists: Array<IntArray>): Boolean = lists.any { list -> list.isNotEmpty() && list[1] == SAID }

    /** A column of [size] spheres without partners. */
    fun column(size: Int): Array<IntArray> = Array(size) { FREE }

    /** The state of the pair with the sphere [partner]. */
    fun state(list: IntArray, partner: Int): Int {
        for (k in list.indices step 2) if (list[k] == partner) return list[k + 1]
        return UNBOUND
    }

    /** The same list, but with [state] for the pair with the sphere [partner]. */
    fun with(list: IntArray, partner: Int, state: Int): IntArray {
        var at = 0
        while (at < list.size && list[at] < partner) at += 2
        val isThere = at < list.size && list[at] == partner
        val next = if (isThere) at + 2 else at
        if (state == UNBOUND) {
            if (!isThere) return list
            return if (list.size == 2) FREE else list.copyOfRange(0, at) + list.copyOfRange(next, list.size)
        }
        val all = IntArray(list.size + if (isThere) 0 else 2)
        list.copyInto(all, 0, 0, at)
        all[at] = partner
        all[at + 1] = state
        list.copyInto(all, at + 2, next)
        return all
    }

    /** The list without the partners that are not [there]. */
    inline fun only(list: IntArray, there: (partner: Int) -> Boolean): IntArray {
        var kept = list
        for (k in list.indices step 2) if (!there(list[k])) kept = with(kept, list[k], UNBOUND)
        return kept
    }

    /** The spheres [gone] are nobody's partners in [lists] any more. */
    fun forget(lists: Array<IntArray>, gone: IntArray) {
        if (gone.isEmpty()) return
        val ids = gone.toHashSet()
        for (k in lists.indices) lists[k] = only(lists[k]) { it !in ids }
    }

    /** Each pair once: lower id, higher id, state, for the spheres in the order of [indices]. */
    fun pairs(spheres: SphereColumns, indices: IntArray): IntArray {
        if (spheres.bonds === NONE) return FREE
        var size = 0
        forEachPair(spheres, indices) { _, _, _ -> size += PAIR }
        val all = IntArray(size)
        var at = 0
        forEachPair(spheres, indices) { lower, higher, state ->
            all[at++] = lower
            all[at++] = higher
            all[at++] = state
        }
        return all
    }

    /** The same without states: lower and higher id of each pair. */
    fun partners(spheres: SphereColumns, indices: IntArray): IntArray {
        val pairs = pairs(spheres, indices)
        return IntArray(pairs.size / PAIR * 2) { pairs[it / 2 * PAIR + it % 2] }
    }

    private inline fun forEachPair(
        spheres: SphereColumns,
        indices: IntArray,
        use: (lower: Int, higher: Int, state: Int) -> Unit,
    ) {
        for (index in indices) {
            val id = spheres.id[index]
            val list = spheres.bonds[index]
            for (k in list.indices step 2) if (list[k] > id) use(id, list[k], list[k + 1])
        }
    }

    /**
     * The column of the spheres [ids] with [pairs] as [Bonds.pairs] gives them.
     *
     * @throws IllegalArgumentException for numbers that are no such pairs
     */
    fun column(ids: IntArray, pairs: IntArray): Array<IntArray> {
        require(pairs.size % PAIR == 0) { "pairs have ${pairs.size} numbers, which is no multiple of $PAIR" }
        val places = HashMap<Int, Int>(2 * ids.size)
        for (k in ids.indices) places[ids[k]] = k
        val column = column(ids.size)
        for (k in pairs.indices step PAIR) {
            val (lower, higher) = pairs[k] to pairs[k + 1]
            val (first, second) = places[lower] to places[higher]
            val isPair = first != null && second != null && lower < higher && pairs[k + 2] > UNBOUND
            require(isPair) { "there is a pair of $lower and $higher" + inState(pairs[k + 2]) }
            require(state(column[first!!], higher) == UNBOUND) { "the pair of $lower and $higher is there twice" }
            column[first] = with(column[first], higher, pairs[k + 2])
            column[second!!] = with(column[second], lower, pairs[k + 2])
        }
        return column
    }

    private fun inState(state: Int) = if (state == SAID) "" else " in state $state"

    private const val PAIR = 3
}
