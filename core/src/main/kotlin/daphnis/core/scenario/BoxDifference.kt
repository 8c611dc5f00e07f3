package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.at
import daphnis.core.format.Snapshot
import kotlin.math.abs

/**
 * In what the box that a file has differs from that of a scenario.
 *
 * @property key of the scenario
 * @property problem what both are, as a part of a message
 */
public class BoxDifference private constructor(public val key: String, public val problem: String) {
    public companion object {
        /** As much as single precision and the digits of a text lose. */
        private const val SAME = 1e-6

        /**
         * The first difference between [boundary] at [time] and what [snapshot] says; null where it says nothing or
         * the same. Along an axis on which [boundary] is open there is nothing to compare.
         *
         * @param file what to call the file
         */
        @JvmStatic
        public fun of(boundary: BoundaryConditions, snapshot: Snapshot, time: Double, file: String): BoxDifference? =
            ofBoxes(boundary.at(time), snapshot, time, file)

        private fun ofBoxes(
            boundary: BoundaryConditions,
            snapshot: Snapshot,
            time: Double,
            file: String,
        ): BoxDifference? {
            for (axis in 0..2) {
                val there = snapshot.lengths[axis]
                val here = boundary.box.length(axis)
                if (there.isNaN() || boundary.contactFaces(axis) == ContactFaces.OPEN) continue
                if (abs(there - here) <= SAME * here) continue
                return BoxDifference("box.lengths[$axis]", "is $here; the box of $file is $there along ${"xyz"[axis]}")
            }
            return lean(boundary, snapshot, time, file)
        }

        /**
         * A line where the box that [snapshot] has ends at faces through which spheres of [boundary] touch; null for
         * nothing. A file may not know better, so it is no difference.
         */
        internal fun ofFaces(boundary: BoundaryConditions, snapshot: Snapshot, file: String): String? {
            if (snapshot.lengths.all { it.isNaN() }) return null
            val axes = (0..2).filter { boundary.repeats(it) && !snapshot.periodic[it] }
            if (axes.isEmpty()) return null
            val names = axes.joinToString(" and ") { "${"xyz"[it]}" }
            return "$file: the box there does not repeat along $names; here it does, as boundary says"
        }

        private fun lean(
            boundary: BoundaryConditions,
            snapshot: Snapshot,
            time: Double,
            file: String,
        ): BoxDifference? {
            val along = snapshot.slideAxis
            val length = snapshot.lengths[along]
            val leans = !snapshot.lengths[snapshot.normalAxis].isNaN() && !isWhole(snapshot.shearOffset, length)
            val shear = boundary.shear
            val there = "the box of $file leans by ${snapshot.shearOffset} along ${"xyz"[along]} " +
                "across ${"xyz"[snapshot.normalAxis]}"
            if (shear == null) {
                if (!leans || !boundary.repeats(snapshot.normalAxis)) return null
                return BoxDifference("boundary", "has images that do not slide; $there")
            }
            val isOtherWay = shear.normalAxis != snapshot.normalAxis || along != shear.slideAxis
            val here = shear.offset(time)
            val slid = "has images that slid by $here along ${"xyz"[shear.slideAxis]} " +
                "across ${"xyz"[shear.normalAxis]} at time $time"
            if (snapshot.lengths.any { it.isNaN() }) return null
            // An upright box says no axes of a slide: it is whole by the edge along which images slide.
            val isSame = if (isOtherWay) {
                !leans && isWhole(here, snapshot.lengths[shear.slideAxis])
            } else {
                isWhole(here - snapshot.shearOffset, length)
            }
            return if (isSame) null else BoxDifference("boundary", "$slid; $there")
        }

        /** Whether a displacement by [offset] leads from an image to another. */
        private fun isWhole(offset: Double, length: Double): Boolean =
            !(length > 0) || abs(offset - Math.rint(offset / length) * length) <= SAME * length
    }
}
