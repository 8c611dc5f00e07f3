package daphnis.core.queue

import daphnis.core.space.Images

/**
 * The order of events beyond time: by lower id, then higher id, then image as seen from the lower id. Reached only when
 * two times are equal to the last bit, as in symmetric lattices.
 *
 * @return negative, zero or positive like a comparator
 */
internal fun compareTied(
    ids: IntArray,
    first: Int,
    second: Int,
    image: Int,
    otherFirst: Int,
    otherSecond: Int,
    otherImage: Int,
): Int {
    val a = idOf(ids, first)
    val b = idOf(ids, second)
    val c = idOf(ids, otherFirst)
    val d = idOf(ids, otherSecond)
    val byLower = minOf(a, b).compareTo(minOf(c, d))
    if (byLower != 0) return byLower
    val byHigher = maxOf(a, b).compareTo(maxOf(c, d))
    if (byHigher != 0) return byHigher
    val fromLower = if (a < b) image else Images.negated(image)
    val otherFromLower = if (c < d) otherImage else Images.negated(otherImage)
    return fromLower.compareTo(otherFromLower)
}

private fun idOf(ids: IntArray, slot: Int): Int = if (slot < 0) slot else ids[slot]
