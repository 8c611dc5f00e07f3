package daphnis.core.format

import daphnis.core.input.ValueCheck
import daphnis.core.population.Bonds
import daphnis.core.population.SphereQuantity
import kotlin.math.abs

/**
 * Checks in one place what every format promises: that the numbers of a [snapshot] can be a state. Sizes and places are
 * kept so far from the limits of a double that volumes and squared distances neither underflow nor overflow.
 *
 * @param where file, and line or frame, for messages: of a particle, or of the state for −1
 */
internal class SnapshotCheck private constructor(private val snapshot: Snapshot, private val where: (Int) -> String) {
    private fun check() {
        must(abs(snapshot.time) <= FARTHEST) { "the time is ${snapshot.time}; it must be a number within ±$FARTHEST" }
        must(snapshot.step >= 0) { "the step is ${snapshot.step}; it must be at least 0" }
        if (snapshot.size == 0) return
        ids()
        sizes()
        box()
        for (axis in 0..2) places(axis)
        rates()
        resolution()
        bound()
    }

    private fun bound() {
        val pairs = snapshot.bound ?: return
        must(pairs.size % 2 == 0) { "connectivity/bound has ${pairs.size} numbers; it must be pairs of ids" }
        try {
            Bonds.of(snapshot.id, pairs)
        } catch (e: IllegalArgumentException) {
            must(false) { "connectivity/bound: ${e.message}" }
        }
    }

    private fun ids() {
        for ((k, id) in snapshot.id.withIndex()) must(id >= 0, k) { "id $id must be at least 0" }
        val twice = lastRepeated(snapshot.size) { snapshot.id[it] }
        must(twice < 0, twice) { "id ${snapshot.id[twice]} occurs twice" }
    }

    private fun sizes() {
        for (k in 0 until snapshot.size) {
            must(snapshot.radius[k] in LEAST..MOST, k) {
                "the radius of particle ${snapshot.id[k]} is ${snapshot.radius[k]}; it must be > 0, $LEAST to $MOST"
            }
            must(snapshot.mass[k] > 0 && snapshot.mass[k].isFinite(), k) {
                "the mass of particle ${snapshot.id[k]} is ${snapshot.mass[k]}; it must be > 0 and finite"
            }
        }
    }

    private fun box() {
        val widest = if (snapshot.hasRadius) 2 * snapshot.radius.max() else 0.0
        for (axis in 0..2) {
            val length = snapshot.lengths[axis]
            if (length.isNaN()) continue
            must(length in LEAST..MOST) {
                "the edge of the box along ${"xyz"[axis]} is $length; it must be > 0, $LEAST to $MOST"
            }
            must(!snapshot.periodic[axis] || length > widest) {
                "the edge of the periodic box along ${"xyz"[axis]} is $length; " +
                    "it must exceed the largest diameter, $widest"
            }
        }
        must(abs(snapshot.shearOffset) <= FARTHEST) {
            "the offset of sliding images is ${snapshot.shearOffset}; it must be a number within ±$FARTHEST"
        }
    }

    private fun places(axis: Int) {
        val name = "xyz"[axis]
        val length = snapshot.lengths[axis]
        val farthest = if (snapshot.periodic[axis] && !length.isNaN()) length * MOST_BOXES else Double.POSITIVE_INFINITY
        for (k in 0 until snapshot.size) {
            val p = snapshot.position[axis][k]
            must(abs(p) <= FARTHEST, k) {
                "$name of particle ${snapshot.id[k]} is $p; it must be a number within ±$FARTHEST"
            }
            must(abs(p) <= farthest, k) {
                "$name of particle ${snapshot.id[k]} is $p, more than $MOST_BOXES boxes of $length away; " +
                    "places must be wrapped into the box"
            }
        }
    }

    /** Speeds, and whatever else can have either sign. */
    private fun rates() {
        for (quantity in SphereQuantity.EXPORTED) {
            if (quantity.isPositive || quantity == SphereQuantity.POSITION) continue
            for ((column, name) in snapshot.columns(quantity).zip(quantity.columns)) {
                for (k in column.indices) {
                    must(abs(column[k]) <= FARTHEST, k) {
                        "$name of particle ${snapshot.id[k]} is ${column[k]}; it must be a number within ±$FARTHEST"
                    }
                }
            }
        }
    }

    /** Compared with the largest coordinate, the smallest sphere must have a size. */
    private fun resolution() {
        var far = 0.0
        for (length in snapshot.lengths) if (!length.isNaN()) far = maxOf(far, length)
        for (column in snapshot.position) for (p in column) far = maxOf(far, abs(p))
        val least = snapshot.radius.min()
        must(far + least * VISIBLE > far) {
            "coordinates and edges are up to $far, compared with which a radius of $least is lost in rounding"
        }
    }

    private inline fun must(ok: Boolean, particle: Int = -1, problem: () -> String) {
        if (!ok) throw FormatException("${where(particle)}: ${problem()}")
    }

    companion object {
        /** Bounds on sizes, those of [daphnis.core.search.Scales]. */
        const val LEAST: Double = ValueCheck.LEAST
        const val MOST: Double = ValueCheck.MOST

        /** Bound on coordinates, times and speeds, whose squares are finite. */
        private const val FARTHEST = 1e150

        /** Bound on how far outside a periodic box a particle can be, whose boxes are counted. */
        private const val MOST_BOXES = 1_000_000

        /** The part of a radius that must be resolved. */
        private const val VISIBLE = 0.01

        /**
         * The last place of the least of the numbers [at] the places before [size] that occur more than once; −1 when
         * all differ. Reads each number twice at most: a search for each would take the square of their number.
         */
        inline fun lastRepeated(size: Int, at: (Int) -> Int): Int {
            val sorted = IntArray(size) { at(it) }.apply { sort() }
            val k = (1 until size).firstOrNull { sorted[it] == sorted[it - 1] } ?: return -1
            return (size - 1 downTo 0).first { at(it) == sorted[k] }
        }

        /** @throws FormatException for the first number that is wrong */
        fun check(snapshot: Snapshot, where: String) {
            check(snapshot) { where }
        }

        /** The same, where a particle has a place of its own in the file. */
        fun check(snapshot: Snapshot, where: (Int) -> String) {
            SnapshotCheck(snapshot, where).check()
        }
    }
}
