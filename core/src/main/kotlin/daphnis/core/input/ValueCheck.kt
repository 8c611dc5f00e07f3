package daphnis.core.input

import daphnis.core.space.Space
import kotlin.math.abs

/** Turns a wrong value into an [InputException] that names the [source], the key and the value. */
public class ValueCheck(public val source: String) {
    /** Unless [ok]: [key] is [value], and [problem] says what would be right. */
    public inline fun that(key: String, value: Any?, ok: Boolean, problem: () -> String) {
        if (!ok) fail(key, "is ${brief(value)}; ${problem()}")
    }

    /** A check that is not about one value. */
    public inline fun must(key: String, ok: Boolean, problem: () -> String) {
        if (!ok) fail(key, problem())
    }

    /** [value] must be > 0 and finite. */
    public fun positive(key: String, value: Double) {
        that(key, value, value > 0 && value.isFinite()) { "must be > 0" }
    }

    /** [value] must be at least 0, which is what [ofZero] says. */
    @JvmOverloads
    public fun atLeast0(key: String, value: Double, ofZero: String? = null) {
        that(key, value, value >= 0) { "must be at least 0" + ofZero?.let { " ($it)" }.orEmpty() }
    }

    /** A [vector] may not point out of the plane, where [space] is one. */
    public fun inSpace(key: String, vector: List<Double>, space: Space) {
        that(key, vector, !space.isPlane || vector[2] == 0.0) { "must have 0 along z, with dimensions 2" }
    }

    /** A mass: of one so small that it has few digits left, or so large, sums of masses and energies have none. */
    public fun mass(key: String, value: Double) {
        that(key, value, value in MASSES) { "must be > 0, ${MASSES.start} to ${MASSES.endInclusive}" }
    }

    /** The same of the [mass] that a sphere of [radius] has by the [density] at [key]. */
    public fun mass(key: String, density: Double, radius: Double, mass: Double) {
        that(key, density, mass in MASSES) {
            "gives a sphere of radius $radius the mass $mass, which must be ${MASSES.start} to ${MASSES.endInclusive}"
        }
    }

    /** A length or a radius. */
    public fun extent(key: String, value: Double) {
        val range = LEAST..MOST
        that(key, value, value in range) { "must be > 0, ${range.start} to ${range.endInclusive}" }
    }

    /** A component of a velocity, or a difference of two. */
    public fun speed(key: String, value: Double) {
        that(key, value, abs(value) <= MOST) { "must be in ±$MOST" }
    }

    /** [value] must be in 0 to 1. */
    public fun fraction(key: String, value: Double) {
        that(key, value, value in 0.0..1.0) { "must be in [0, 1]" }
    }

    /** Shortens a list, which may have any length. */
    public fun brief(value: Any?): String {
        val text = value.toString()
        return if (text.length > MOST_SHOWN) text.take(MOST_SHOWN) + "…" else text
    }

    /** [key] has a [problem]. */
    public fun fail(key: String, problem: String): Nothing = throw InputException(source, key, problem)

    public companion object {
        /** Bounds on lengths; speeds are at most [MOST]. Those of [daphnis.core.search.Scales]. */
        public const val LEAST: Double = 1e-70
        public const val MOST: Double = 1e70
        private const val MOST_SHOWN = 100
        private val MASSES = 1e-290..1e290
    }
}
