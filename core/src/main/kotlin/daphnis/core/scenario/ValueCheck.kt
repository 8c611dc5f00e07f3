package daphnis.core.scenario

import daphnis.core.format.SnapshotCheck
import kotlin.math.abs

/** Turns a wrong value into an [InputException] that names the [source], the key and the value. */
internal class ValueCheck(val source: String) {
    inline fun that(key: String, value: Any?, ok: Boolean, problem: () -> String) {
        if (!ok) fail(key, "is ${brief(value)}; ${problem()}")
    }

    /** A check that is not about one value. */
    inline fun must(key: String, ok: Boolean, problem: () -> String) {
        if (!ok) fail(key, problem())
    }

    fun positive(key: String, value: Double) {
        that(key, value, value > 0 && value.isFinite()) { "must be > 0" }
    }

    /** A mass: one so small that it has few digits left gives sums of masses none. */
    fun mass(key: String, value: Double) {
        positive(key, value)
        that(key, value, value >= LEAST_MASS) { "must be at least $LEAST_MASS" }
    }

    /** A length or a radius. */
    fun extent(key: String, value: Double) {
        val range = SnapshotCheck.LEAST..SnapshotCheck.MOST
        that(key, value, value in range) { "must be > 0, ${range.start} to ${range.endInclusive}" }
    }

    /** A component of a velocity, or a difference of two. */
    fun speed(key: String, value: Double) {
        that(key, value, abs(value) <= SnapshotCheck.MOST) { "must be in ±${SnapshotCheck.MOST}" }
    }

    fun fraction(key: String, value: Double) {
        that(key, value, value in 0.0..1.0) { "must be in [0, 1]" }
    }

    /** Shortens a list, which may have any length. */
    fun brief(value: Any?): String {
        val text = value.toString()
        return if (text.length > MOST_SHOWN) text.take(MOST_SHOWN) + "…" else text
    }

    fun fail(key: String, problem: String): Nothing = throw InputException(source, key, problem)

    private companion object {
        const val MOST_SHOWN = 100
        const val LEAST_MASS = 1e-290
    }
}
