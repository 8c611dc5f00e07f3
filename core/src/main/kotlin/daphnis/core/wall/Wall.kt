package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.surface.Roughness
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A wall: a surface, and what happens there. A face of the box is a [PlaneWall]; others are planes, [CylinderWall]s and
 * [SphereWall]s anywhere. Points, vectors and velocities are given along x, y, z, in the units of the positions.
 *
 * A wall of another shape is one more class, which says what is here, and what happens within a step as a
 * [ContactWall]. A surface of revolution is a [CurvedWall], which has that.
 *
 * @param face what the wall has of its own
 * @property roughness null for a smooth surface; spheres need spins where there is any
 */
public abstract class Wall(face: WallFace, public val roughness: Roughness?) {
    /** Its coefficient of restitution in place of that of all walls; null for that. */
    public val restitution: Double? = face.restitution

    /** How it moves, or null where it rests. */
    public val motion: WallMotion? = face.motion

    /**
     * Its temperature, mass · (length/time)², or null where it is not thermal. A sphere leaves a thermal wall as if it
     * came from a gas of that temperature beyond it.
     */
    public val temperature: Double? = face.temperature

    /** Whether it moves, is thermal, or moves along itself. */
    public val isDriven: Boolean get() = motion != null || temperature != null || glides

    /** Whether it moves along itself, as a belt or a drum does. */
    public open val glides: Boolean get() = false

    /** Whether it moves along itself along [axis] everywhere. */
    public open fun glides(axis: Int): Boolean = false

    /** Distance of the point ([x], [y], [z]) from the surface at [time], negative beyond it. */
    @JvmOverloads
    public fun distance(x: Double, y: Double, z: Double, time: Double = 0.0): Double =
        distanceAt(x, y, z, motion?.displacement(time) ?: 0.0)

    /** The same of a wall that has moved by [moved]. */
    public abstract fun distanceAt(x: Double, y: Double, z: Double, moved: Double): Double

    /** Writes the unit normal into the room at the point ([x], [y], [z]) to [into]; 0 where there is none. */
    public abstract fun normal(x: Double, y: Double, z: Double, time: Double, into: DoubleArray)

    /** Whether the surface is the same everywhere along [axis] (0 = x, 1 = y, 2 = z). */
    public abstract fun isSameAlong(axis: Int): Boolean

    /** Whether it keeps spheres between [lower] and [upper] along [axis] by itself. */
    public open fun encloses(axis: Int, lower: Double, upper: Double): Boolean = false

    /** Whether there is room for a sphere of [radius]; where there is not, it is the wall's own radius that is small. */
    public open fun fits(radius: Double): Boolean = true

    /** Infinite where there is none. */
    public open val radius: Double get() = Double.POSITIVE_INFINITY

    /** The greatest coordinate or length that it is given by. */
    public abstract val farthest: Double

    /** Whether the room is where [cut] says; else all around that. */
    public open val isRoomWithin: Boolean get() = true

    /**
     * Writes to [into] where the line through [at] along [axis] enters the convex side of the surface at time 0, and
     * where it leaves; +∞ and −∞ where it is never there.
     */
    public abstract fun cut(at: DoubleArray, axis: Int, into: DoubleArray)

    /** Volume of the room that it encloses by itself, in a box of [lengths] along the [axes] that there are, if known. */
    internal open fun volume(axes: IntRange, lengths: (Int) -> Double): Double? = null

    /** The wall within steps, as the one of [number] of [walls]. */
    internal abstract fun contact(number: Int, walls: WallSet, law: CollisionLaw): ContactWall

    /** Requires that what the wall has of its own goes together. */
    protected fun requireSelf(vararg turning: Double) {
        require(temperature == null || roughness == null) { "a wall that is thermal cannot be rough" }
        require(motion?.isKnownAhead != false || roughness == null) { "a wall that is a piston cannot be rough" }
        require(turning.all { it.isFinite() }) {
            "the surface moves along itself with ${turning.toList()}; give three finite numbers"
        }
    }

    internal companion object {
        const val AXES = 3
        val STILL = listOf(0.0, 0.0, 0.0)

        fun vector(name: String, components: List<Double>): DoubleArray {
            require(components.size == AXES && components.all { it.isFinite() }) {
                "$name is $components; give three finite numbers"
            }
            return components.toDoubleArray()
        }

        /** Exact along an axis, and otherwise to rounding. */
        fun unit(name: String, components: List<Double>): DoubleArray {
            val v = vector(name, components)
            val scale = v.maxOf { abs(it) }
            require(scale > 0) { "$name is $components; it must have a length > 0" }
            for (k in v.indices) v[k] /= scale
            val length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
            for (k in v.indices) v[k] = v[k] / length + 0.0
            return v
        }
    }
}

/** On which side of a surface the spheres are. */
public enum class RoomSide { INSIDE, OUTSIDE }

/**
 * What one wall has of its own.
 *
 * @property restitution its coefficient of restitution, in [0, 1], in place of that of all walls; null for that
 * @property motion how it moves; null when it rests. A [Piston] is not thermal
 * @property temperature T of a thermal wall, mass · (length/time)², > 0; null for one that reflects. From a thermal
 *   wall spheres of mass m leave with velocities drawn from the flux of a gas of that temperature: relative to the
 *   wall, the density of the normal speed c is (m c/T) exp(−m c²/2T), and the components along the wall are normal with
 *   variance T/m. Restitution does not matter there, and the wall is not rough
 */
public class WallFace @JvmOverloads constructor(
    public val restitution: Double? = null,
    public val motion: WallMotion? = null,
    public val temperature: Double? = null,
) {
    init {
        require(restitution == null || restitution in 0.0..1.0) {
            "wall restitution is $restitution; it must be in [0, 1]"
        }
        require(temperature == null || temperature > 0 && temperature.isFinite()) {
            "temperature of a wall is $temperature; it must be > 0"
        }
        require(temperature == null || motion?.isKnownAhead != false) { "a wall is a piston; it cannot be thermal" }
    }
}
