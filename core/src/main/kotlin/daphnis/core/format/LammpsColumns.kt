package daphnis.core.format

import daphnis.core.population.SphereQuantity

/**
 * The places of the columns that a LAMMPS dump [names], −1 for those that are not there.
 *
 * @param fail refuses the file
 */
internal class LammpsColumns(private val names: List<String>, fail: (String) -> Nothing) {
    init {
        val twice = names.find { name -> names.count { it == name } > 1 }
        if (twice != null) fail("ITEM: ATOMS names '${TextLines.shown(twice)}' twice")
    }

    val width = names.size

    /** That of daphnis, where the file also has one from 1 on for LAMMPS. */
    val id = maxOf(names.indexOf(OWN_ID), if (OWN_ID in names) -1 else names.indexOf("id"))
    val diameter = names.indexOf("diameter")
    val type = names.indexOf("type")
    private val places = NUMBERED.associateWith { quantity ->
        IntArray(quantity.columns.size) { names.indexOf(quantity.columns[it]) }
    }

    /** The columns of [quantity], other than the position. */
    operator fun get(quantity: SphereQuantity): IntArray = places.getValue(quantity)

    /** Quantities all of whose columns are there. */
    val known = places.keys.filterTo(HashSet()) { quantity ->
        places.getValue(quantity).all { it >= 0 } || quantity == SphereQuantity.RADIUS && diameter >= 0
    }

    private val kind = Array(3) { axis ->
        KINDS.find { "${"xyz"[axis]}$it" in names } ?: fail(
            "ITEM: ATOMS has no x y z; columns x y z, xu yu zu, xs ys zs or xsu ysu zsu are needed",
        )
    }
    val position = IntArray(3) { names.indexOf("xyz"[it] + kind[it]) }

    /** Boxes crossed; −1 along axes whose positions are those without a box. */
    val image = IntArray(3) { if (isUnwrapped(it)) -1 else names.indexOf(IMAGE[it]) }

    /** Whether the position along [axis] is in units of the box. */
    fun isScaled(axis: Int): Boolean = kind[axis].startsWith("s")

    /** Whether the position along [axis] goes on beyond the box. */
    fun isUnwrapped(axis: Int): Boolean = kind[axis].endsWith("u")

    /** Whether it is known how often particles crossed a box that repeats along the axes marked in [periodic]. */
    fun knowsImages(periodic: BooleanArray): Boolean =
        periodic.any { it } && (0..2).all { !periodic[it] || isUnwrapped(it) || image[it] >= 0 }

    /** The names of columns that are not read and mean something to LAMMPS' dynamics. */
    fun unused(): List<String> {
        val read = (position + image).toSet() + places.values.flatMap { it.asList() } + setOf(id, diameter)
        val others = (0..2).flatMap { axis -> KINDS.map { "${"xyz"[axis]}$it" } } + IMAGE
        return names.filterIndexed { k, name -> k !in read && name !in SILENT && name !in others }
    }

    companion object {
        /** A column with the ids of daphnis, which are from 0; named as LAMMPS names one of a user's own. */
        const val OWN_ID = "i_daphnis"

        /** Boxes crossed along each axis. */
        val IMAGE = listOf("ix", "iy", "iz")

        /** What may stand behind x, y and z; what tells most is first. */
        private val KINDS = listOf("u", "su", "", "s")
        private val SILENT = setOf("id", "type", "element", "mol", "proc", "procp1")
    }
}
