package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.space.Space

/**
 * The walls of a boundary, each with a number: those of the faces −x, +x, −y, +y, −z, +z of the box are 0 to 5, and
 * others follow. Order is that of the numbers.
 *
 * @param faces the walls at the six faces, null where there is none; or none at all
 * @property surfaces walls that are not faces of the box, numbered from [FACES] on
 * @property restitution coefficient of walls that have none of their own, in [0, 1]
 * @property seed decides about all that thermal walls draw
 * @property space in which they stand
 */
public class WallSet internal constructor(
    private val faces: List<Wall?>,
    public val surfaces: List<Wall> = emptyList(),
    public val restitution: Double = 1.0,
    public val seed: Long = 0,
    public val space: Space = Space.VOLUME,
) : Iterable<Wall> {
    init {
        require(restitution in 0.0..1.0) { "wall restitution is $restitution; it must be in [0, 1]" }
    }

    /** The numbers of those that there are. */
    public val numbers: List<Int> =
        faces.indices.filter { faces[it] != null } + List(surfaces.size) { FACES + it }

    /** The wall of [number], or null where there is none. */
    public operator fun get(number: Int): Wall? =
        if (number < FACES) faces.getOrNull(number) else surfaces.getOrNull(number - FACES)

    override fun iterator(): Iterator<Wall> = numbers.map { get(it)!! }.iterator()

    /** Whether there is none. */
    public val isEmpty: Boolean get() = numbers.isEmpty()

    /** Whether any moves, is thermal, or moves along itself. */
    public val areDriven: Boolean = any { it.isDriven }

    /** Whether all motions are known beyond the present step. */
    internal val areKnownAhead: Boolean = all { it.motion?.isKnownAhead ?: true }

    /** All of them within steps. */
    internal fun contacts(law: CollisionLaw): Array<ContactWall> =
        Array(numbers.size) { get(numbers[it])!!.contact(numbers[it], this, law) }

    public companion object {
        /** Of the box. */
        public const val FACES: Int = 6

        /** No walls. */
        @JvmField
        public val NONE: WallSet = WallSet(emptyList())
    }
}
