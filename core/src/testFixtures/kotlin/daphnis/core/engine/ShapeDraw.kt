package daphnis.core.engine

import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.initial.SeededRandom
import daphnis.core.surface.Roughness
import daphnis.core.wall.CylinderWall
import daphnis.core.wall.PlaneWall
import daphnis.core.wall.RoomSide
import daphnis.core.wall.SphereWall
import daphnis.core.wall.Wall
import daphnis.core.wall.WallFace
import daphnis.core.wall.WallMotion
import kotlin.math.sqrt

/**
 * Walls of other shapes of a drawn case, in half of those between walls: planes, cylinders and spheres that just let
 * the spheres in as they are, some turning, thermal, or moving. They have random numbers of their own.
 */
class ShapeDraw(seed: Long) {
    private val random = SeededRandom(seed + APART)
    private val isThere = random.nextInt(2) == 0
    private lateinit var at: Array<DoubleArray>
    private lateinit var radii: DoubleArray
    private var rough: List<Roughness?> = emptyList()

    /**
     * Walls around spheres at [places] with [radii], made by [walls] of surfaces and a box, which is wider than [box]
     * where a surface is to keep the spheres from its faces.
     */
    fun around(
        box: Box,
        walled: BooleanArray,
        roughness: List<Roughness?>,
        places: Array<DoubleArray>,
        radii: DoubleArray,
        walls: (List<Wall>, Box) -> Walls,
    ): Walls {
        if (!isThere) return walls(emptyList(), box)
        at = places
        this.radii = radii
        rough = roughness
        if (walled.any { !it }) return walls(listOf(plane(List(3) { if (it == 1) 1.0 else 0.0 })), box)
        val kinds = 1 + random.nextInt(2)
        val surfaces = List(kinds) { drawn(box) }
        val isWide = random.nextInt(2) == 0
        val wide = if (isWide) Box.centred(9 * box.length(0), 9 * box.length(1), 9 * box.length(2)) else box
        return walls(surfaces, wide)
    }

    private fun drawn(box: Box): Wall = when (random.nextInt(6)) {
        0, 1 -> plane(List(3) { random.nextGaussian() })
        2 -> cylinder(List(3) { if (it == 2) 1.0 else 0.0 })
        3 -> cylinder(List(3) { random.nextGaussian() })
        4 -> vessel()
        else -> body(box)
    }

    private fun speeds() = List(3) { if (random.nextInt(2) == 0) 0.0 else random.nextGaussian() }

    private fun face(motion: WallMotion?, roughness: Roughness?) = WallFace(
        if (random.nextInt(2) == 0) null else random.nextDouble(),
        motion,
        if (roughness == null && random.nextInt(4) == 0) random.nextDouble(0.1, 2.0) else null,
    )

    private fun roughness() = rough.getOrNull(random.nextInt(6))

    private fun motion(retreats: Double): WallMotion? = when (random.nextInt(3)) {
        0 -> WallMotion.Steady(-0.3 * retreats * random.nextDouble())
        1 -> WallMotion.Sine(0.05, random.nextDouble(0.1, 1.0))
        else -> null
    }

    /** The least of [of] over all spheres, of place and radius. */
    private fun least(of: (Double, Double, Double, Double) -> Double) =
        radii.indices.minOf { of(at[0][it], at[1][it], at[2][it], radii[it]) }

    private fun plane(normal: List<Double>): Wall {
        val length = sqrt(normal.sumOf { it * it })
        val n = normal.map { it / length }
        val motion = motion(1.0)
        val room = if (motion is WallMotion.Sine) 0.06 else 0.0
        val far = least { x, y, z, r -> n[0] * x + n[1] * y + n[2] * z - r } - room
        val belt = speeds().let { s ->
            val across = (0..2).sumOf { s[it] * n[it] }
            List(3) { s[it] - across * n[it] }
        }
        val roughness = roughness()
        return PlaneWall(n.map { it * far }, n, face(motion, roughness), roughness, belt)
    }

    private fun cylinder(axis: List<Double>): Wall {
        val length = sqrt(axis.sumOf { it * it })
        val a = axis.map { it / length }
        val radius = -least { x, y, z, r ->
            val along = a[0] * x + a[1] * y + a[2] * z
            val p = doubleArrayOf(x - along * a[0], y - along * a[1], z - along * a[2])
            -r - sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
        }
        val roughness = roughness()
        val centre = listOf(0.0, 0.0, 0.0)
        val turning = random.nextGaussian() / radius
        return CylinderWall(
            centre,
            axis,
            radius * (1 + 1e-9),
            RoomSide.INSIDE,
            face(null, roughness),
            roughness,
            turning,
        )
    }

    private fun vessel(): Wall {
        val c = List(3) { 0.1 * random.nextGaussian() }
        val radius = -least { x, y, z, r -> -r - distance(x, y, z, c) }
        val roughness = roughness()
        val face = face(null, roughness)
        return SphereWall(c, radius * (1 + 1e-9), RoomSide.INSIDE, face, roughness, speeds())
    }

    /** A body where there is room for one, maybe at the side of the box. */
    private fun body(box: Box): Wall {
        var best = listOf(2 * box.upperX, 0.0, 0.0)
        repeat(20) {
            val c = List(3) { axis -> random.nextDouble(box.lower(axis), box.upper(axis)) }
            if (room(c) > room(best) || room(best) > 3) best = c
        }
        val motion = motion(0.0)
        val radius = (room(best) - if (motion == null) 0.0 else 0.06).coerceAtMost(3.0)
        if (radius <= 0) return plane(List(3) { random.nextGaussian() })
        val roughness = roughness()
        val face = face(motion, roughness)
        return SphereWall(best, radius, RoomSide.OUTSIDE, face, roughness, speeds(), listOf(1.0, 1.0, 0.5))
    }

    private fun room(c: List<Double>) = least { x, y, z, r -> distance(x, y, z, c) - r }

    private fun distance(x: Double, y: Double, z: Double, c: List<Double>) =
        sqrt((x - c[0]) * (x - c[0]) + (y - c[1]) * (y - c[1]) + (z - c[2]) * (z - c[2]))

    private companion object {
        const val APART = 1L shl 46
    }
}
