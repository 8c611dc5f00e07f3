package daphnis.core.scenario

import daphnis.core.boundary.Piston
import daphnis.core.boundary.WallFace
import daphnis.core.boundary.WallMotion
import daphnis.core.input.ValueCheck
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction

/** How a wall moves along the axis across it, see [WallMotion]; toward greater coordinates is positive. */
@Serializable
public sealed interface WallMotionSpec {
    /** A description for a reader: [number] writes numbers. */
    public fun inWords(number: DoubleFunction<String>): String

    /** At one speed: at time 0 at the face of the box. */
    @Serializable
    @SerialName("steady")
    public class Steady(public val velocity: Double) : WallMotionSpec {
        override fun inWords(number: DoubleFunction<String>): String = "moves with ${number.apply(velocity)}"
    }

    /**
     * A wall with a mass, see [daphnis.core.boundary.Piston].
     *
     * @property mass its mass
     * @property force along the axis
     * @property position displacement from the face of the box at the start
     * @property velocity at the start
     */
    @Serializable
    @SerialName("piston")
    public class Piston @JvmOverloads constructor(
        public val mass: Double,
        public val force: Double = 0.0,
        public val position: Double = 0.0,
        public val velocity: Double = 0.0,
    ) : WallMotionSpec {
        override fun inWords(number: DoubleFunction<String>): String =
            "piston of mass ${number.apply(mass)} under the force ${number.apply(force)}"
    }

    /** @property phase part of a cycle, at time 0 */
    @Serializable
    @SerialName("sine")
    public class Sine @JvmOverloads constructor(
        public val amplitude: Double,
        public val frequency: Double,
        public val phase: Double = 0.0,
    ) : WallMotionSpec {
        override fun inWords(number: DoubleFunction<String>): String =
            "sine of amplitude ${number.apply(amplitude)}, frequency ${number.apply(frequency)}"
    }

    /** @property rise part of a cycle that the way up takes */
    @Serializable
    @SerialName("sawtooth")
    public class Sawtooth @JvmOverloads constructor(
        public val amplitude: Double,
        public val frequency: Double,
        public val phase: Double = 0.0,
        public val rise: Double = 0.5,
    ) : WallMotionSpec {
        override fun inWords(number: DoubleFunction<String>): String =
            "sawtooth of amplitude ${number.apply(amplitude)}, frequency ${number.apply(frequency)}, " +
                "of which it rises ${number.apply(rise)}"
    }

    @Serializable
    @SerialName("bi-parabolic")
    public class BiParabolic @JvmOverloads constructor(
        public val amplitude: Double,
        public val frequency: Double,
        public val phase: Double = 0.0,
    ) : WallMotionSpec {
        override fun inWords(number: DoubleFunction<String>): String =
            "bi-parabolic of amplitude ${number.apply(amplitude)}, frequency ${number.apply(frequency)}"
    }
}

/** The motion of what stands at [key]. */
internal fun WallMotionSpec.motion(key: String, check: ValueCheck): WallMotion {
    fun periodic(amplitude: Double, frequency: Double, phase: Double) {
        check.that("$key.amplitude", amplitude, amplitude >= 0 && amplitude.isFinite()) { "must be at least 0" }
        check.positive("$key.frequency", frequency)
        check.that("$key.phase", phase, phase in -1.0..1.0) { "must be a part of a cycle, in [-1, 1]" }
        check.speed("$key.frequency", 2 * Math.PI * frequency * amplitude)
    }
    return when (this) {
        is WallMotionSpec.Steady -> {
            check.speed("$key.velocity", velocity)
            WallMotion.Steady(velocity)
        }
        is WallMotionSpec.Piston -> {
            check.positive("$key.mass", mass)
            check.that("$key.force", force, force.isFinite()) { "must be finite" }
            check.that("$key.position", position, position.isFinite()) { "must be finite" }
            check.speed("$key.velocity", velocity)
            Piston(mass, force, position, velocity)
        }
        is WallMotionSpec.Sine -> {
            periodic(amplitude, frequency, phase)
            WallMotion.Sine(amplitude, frequency, phase)
        }
        is WallMotionSpec.Sawtooth -> {
            periodic(amplitude, frequency, phase)
            check.that("$key.rise", rise, rise > 0 && rise < 1) { "must be a part of a cycle, in (0, 1)" }
            WallMotion.Sawtooth(amplitude, frequency, phase, rise)
        }
        is WallMotionSpec.BiParabolic -> {
            periodic(amplitude, frequency, phase)
            WallMotion.BiParabolic(amplitude, frequency, phase)
        }
    }
}

/** What a wall has of its own, see [WallFace]. */
@Serializable
public class WallFaceSpec @JvmOverloads constructor(
    public val restitution: Double? = null,
    public val motion: WallMotionSpec? = null,
    public val temperature: Double? = null,
) {
    internal fun inWords(number: DoubleFunction<String>): String = listOfNotNull(
        restitution?.let { "restitution ${number.apply(it)}" },
        motion?.inWords(number),
        temperature?.let { "thermal at ${number.apply(it)}" },
    ).joinToString(", ")

    internal fun face(key: String, check: ValueCheck): WallFace {
        restitution?.let { check.fraction("$key.restitution", it) }
        temperature?.let { check.positive("$key.temperature", it) }
        check.must("$key.restitution", restitution == null || temperature == null) {
            "does not matter for a wall with a temperature; give one of the two"
        }
        check.must("$key.temperature", temperature == null || motion !is WallMotionSpec.Piston) {
            "is of a piston; a piston cannot be thermal"
        }
        return WallFace(restitution, motion?.motion("$key.motion", check), temperature)
    }
}

/** What the lower and the upper wall across each axis have of their own. */
@Serializable
public class WallFacesSpec @JvmOverloads constructor(
    public val lowerX: WallFaceSpec? = null,
    public val upperX: WallFaceSpec? = null,
    public val lowerY: WallFaceSpec? = null,
    public val upperY: WallFaceSpec? = null,
    public val lowerZ: WallFaceSpec? = null,
    public val upperZ: WallFaceSpec? = null,
) {
    internal val named: List<WallFaceSpec?> get() = listOf(lowerX, upperX, lowerY, upperY, lowerZ, upperZ)

    /** Those that are pistons, by face. */
    internal val pistons: Map<Int, WallMotionSpec.Piston>
        get() = buildMap {
            named.forEachIndexed { face, spec -> (spec?.motion as? WallMotionSpec.Piston)?.let { put(face, it) } }
        }

    /** The same with pistons at the position and speed in [states], by face. */
    internal fun withPistons(states: Map<Int, List<Double>>): WallFacesSpec {
        val all = named.mapIndexed { face, spec ->
            val piston = spec?.motion as? WallMotionSpec.Piston
            val state = states[face]
            if (piston == null || state == null) return@mapIndexed spec
            val moved = WallMotionSpec.Piston(piston.mass, piston.force, position = state[0], velocity = state[1])
            WallFaceSpec(spec.restitution, moved, spec.temperature)
        }
        return WallFacesSpec(all[0], all[1], all[2], all[3], all[4], all[5])
    }

    /** The faces for a reader, such as `, lowerZ sine of amplitude 1, frequency 2`. */
    internal fun inWords(number: DoubleFunction<String>): String {
        val told = named.mapIndexedNotNull { face, spec -> spec?.let { "${NAMES[face]} ${it.inWords(number)}" } }
        return if (told.isEmpty()) "" else told.joinToString("; ", prefix = ", ")
    }

    /** Of the faces −x, +x, −y, +y, −z, +z; those across [axes] are walls. */
    internal fun faces(axes: String, check: ValueCheck): List<WallFace?> = named.mapIndexed { face, spec ->
        val key = "$KEY.${NAMES[face]}"
        check.must(key, spec == null || "xyz"[face / 2] in axes) { "is of no wall; there are walls across $axes" }
        spec?.face(key, check)
    }

    internal companion object {
        const val KEY = "boundary.faces"
        val NAMES = listOf("lowerX", "upperX", "lowerY", "upperY", "lowerZ", "upperZ")
    }
}
