package daphnis.app

import daphnis.core.format.Snapshot

/** The first thing in which two states are not the same to the last bit, in words; null when there is none. */
internal fun firstDifference(a: Snapshot, b: Snapshot): String? = ofWhole(a, b)
    ?: (0 until a.size).firstNotNullOfOrNull { ofParticle(a, b, it) }

private fun ofWhole(a: Snapshot, b: Snapshot): String? {
    if (!a.id.contentEquals(b.id)) return "the particles are not the same (${a.size} and ${b.size})"
    if (a.hasSpin != b.hasSpin) return "the particles of one have angular velocities, those of the other have none"
    if (a.hasMaterials != b.hasMaterials) return "the particles of one have materials, those of the other have none"
    if (a.materials != b.materials) return "materials are ${a.materials} against ${b.materials}"
    if (a.step != b.step) return "step ${a.step} against ${b.step}"
    if ((a.image == null) != (b.image == null)) {
        return "one knows the boxes that particles have crossed, the other does not"
    }
    number("time", a.time, b.time)?.let { return it }
    for (axis in 0..2) {
        number("the box along ${"xyz"[axis]}", a.lengths[axis], b.lengths[axis])?.let { return it }
        if (a.periodic[axis] != b.periodic[axis]) return "the box repeats along ${"xyz"[axis]} in one of the two"
    }
    if (a.normalAxis != b.normalAxis || a.slideAxis != b.slideAxis) return "images slide along other axes"
    return number("the offset of images", a.shearOffset, b.shearOffset)
}

private fun ofParticle(a: Snapshot, b: Snapshot, k: Int): String? {
    val particle = "particle ${a.id[k]},"
    for ((place, name) in a.columnPlaces.zip(a.columnNames)) {
        number("$particle $name", a.column(place)[k], b.column(place)[k])?.let { return it }
    }
    for (axis in 0..2) {
        val here = a.image?.get(axis)?.get(k)
        val there = b.image?.get(axis)?.get(k)
        if (here != there) return "$particle boxes crossed along ${"xyz"[axis]} = $here against $there"
    }
    return null
}

private fun number(what: String, a: Double, b: Double): String? = if (a.toRawBits() == b.toRawBits()) {
    null
} else {
    "$what = $a against $b"
}
