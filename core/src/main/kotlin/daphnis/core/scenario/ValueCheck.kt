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

    /** A mass: of one so small that it has few digits left, or so large, sums of masses and energies have none. */
    fun mass(key: String, value: Double) {
        that(key, value, value in MASSES) { "must be > 0, ${MASSES.start} to ${MASSES.endInclusive}" }
    }

    /** The same of the [mass] that a sphere of [radius] has by the [density] at [key]. */
    fun mass(key: String, density: Double, radius: Double, mass: Double) {
        that(key, density, mass in MASSES) {
            "gives a sphere of radius $radius the mass $mass, which must be ${MASSES.start} to ${MASSES.endInclusive}"
        }
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
        val MASSES = 1e-290..1e290
    }
}
