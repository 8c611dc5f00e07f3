package daphnis.core.wall

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.collision.WallImpact
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.force.UniformAcceleration
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/** A kind of wall that is written here alone: the inside of a cone, as a gas, engines, volumes and placements see it. */
class ConeWallTest {
    /** Around [axis] from [apex] on, with the [slope] of its side: at h along the axis it is slope · h wide. */
    private class Cone(apex: List<Double>, axis: List<Double>, private val slope: Double) :
        CurvedWall(apex, axis, WallFace(), null) {
        private val cosine = 1 / sqrt(1 + slope * slope)
        private val sine = slope * cosine

        /** From where on along the axis there is room for the middle of a sphere of radius [r]. */
        private fun above(h: Double, r: Double) = h - r / sine

        override fun gap(q2: Double, h: Double, r: Double): Double =
            above(h, r).let { slope * slope * it * abs(it) - q2 }

        override fun rate(qw: Double, h: Double, u: Double, r: Double): Double =
            2 * (slope * slope * abs(above(h, r)) * u - qw)

        override fun bending(
            least: Double,
            most: Double,
            h: Double,
            u: Double,
            fall: Double,
            rest: Double,
            r: Double,
        ): Double {
            val lowest = if (fall == 0.0) 0.0 else (-u / fall).coerceIn(0.0, rest)
            val now = 2 * (u * u + above(h, r) * fall)
            return slope * slope * (now + (6 * u * fall + 3 * fall * fall * lowest) * lowest) - most
        }

        override fun distance(q: Double, h: Double): Double = h * sine - q * cosine

        override fun meet(
            qx: Double,
            qy: Double,
            qz: Double,
            q: Double,
            across: Double,
            fall: Double,
            impact: WallImpact,
        ) {
            val lean = sine * q
            impact.normal(
                lean * direction[0] - cosine * qx,
                lean * direction[1] - cosine * qy,
                lean * direction[2] - cosine * qz,
            )
            impact.length = q
            impact.lean = lean
            impact.press = cosine * across - sine * fall
        }

        override fun isSameAlong(axis: Int): Boolean = false

        override fun cut(at: DoubleArray, axis: Int, into: DoubleArray): Unit =
            across(at[0], at[1], at[2], 0.0) { px, py, pz, h ->
                val a = direction[axis]
                val t = slope * slope
                val qu = doubleArrayOf(px, py, pz)[axis]
                val square = t * a * a - (1 - a * a)
                val half = t * h * a - qu
                val root = half * half - square * (t * h * h - (px * px + py * py + pz * pz))
                val ends = listOf((-half - sqrt(root)) / square, (-half + sqrt(root)) / square)
                val isOpen = square > 0
                val isMet = root > 0 && (isOpen || h + a * ends.average() > 0)
                into[0] = if (!isMet) {
                    1.0
                } else if (isOpen && a < 0) {
                    Double.NEGATIVE_INFINITY
                } else {
                    ends.min()
                }
                into[1] = if (!isMet) {
                    -1.0
                } else if (isOpen && a > 0) {
                    Double.POSITIVE_INFINITY
                } else {
                    ends.max()
                }
                if (isMet && isOpen && a > 0) into[0] = ends.max()
                if (isMet && isOpen && a < 0) into[1] = ends.min()
            }

        override fun toString(): String = "cone from ${origin.toList()} along ${direction.toList()}"
    }

    private val box = Box.centred(12.0, 12.0, 6.0)
    private val cones = listOf(
        Cone(listOf(0.0, 0.0, -3.0), listOf(0.0, 0.0, 2.0), 0.9),
        Cone(listOf(0.0, 0.0, 3.0), listOf(0.0, 0.0, -1.0), 0.9),
        Cone(listOf(-4.0, 1.0, -2.0), listOf(1.0, 0.3, 0.5), 0.6),
    )

    private fun gas(walls: Walls): Population {
        val random = SeededRandom(7)
        val radii = DoubleArray(COUNT) { random.nextDouble(0.1, 0.2) }
        val all = booleanArrayOf(true, true, true)
        val places = RandomPlacement().within(walls.walls.surfaces).place(radii, box, all, random)
        fun gauss() = DoubleArray(COUNT) { random.nextGaussian() }
        return Population(places.x, places.y, places.z, gauss(), gauss(), gauss(), radii, DoubleArray(COUNT) { 1.0 })
    }

    private fun energy(p: Population, g: Double) = (0 until p.size).sumOf {
        0.5 * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) + g * p.z[it]
    }

    /** The state after some steps, and the impacts on walls. */
    private fun run(cone: Cone, g: Double, engine: CollisionEngine): Pair<String, Long> {
        val walls = Walls(box, surfaces = listOf(cone))
        val p = gas(walls)
        val before = energy(p, g)
        val forces = if (g == 0.0) emptyList() else listOf(UniformAcceleration(0.0, 0.0, -g))
        val forcing = CollisionForcing(ConstantRestitution(1.0), engine = engine)
        Simulation(p, walls, forcing, FixedTimeStep(0.2), forces).use { simulation ->
            repeat(STEPS) {
                simulation.advance()
                for (k in 0 until p.size) {
                    assertTrue(cone.distance(p.x[k], p.y[k], p.z[k]) > p.radius[k] * (1 - 1e-9)) { "$cone, $g" }
                }
            }
        }
        assertEquals(before, energy(p, g), 1e-9 * COUNT) { "$cone, $g" }
        return stateDigest(p) to forcing.counters.wallCollisions
    }

    @Test
    fun `a gas stays in it, keeps its energy, and is the same in every engine`() {
        for (cone in cones) {
            for (g in listOf(0.0, 1.5)) {
                val (serial, impacts) = run(cone, g, SerialEngine())
                assertTrue(impacts > 10 * COUNT) { "$impacts" }
                assertEquals(
                    serial,
                    run(cone, g, HorizonEngine(FixedPool(1), fewest = 0, tuning = HorizonTuning(3))).first,
                ) {
                    "$cone, $g"
                }
                assertEquals(serial, run(cone, g, IslandsEngine(FixedPool(2), fewest = 0)).first) { "$cone, $g" }
            }
        }
    }

    @Test
    fun `the room is what it cuts off`() {
        for (cone in cones.take(2)) {
            // At the end it is 5.4 wide, and the box 6.
            assertEquals(PI * 0.81 * 72, Walls(box, surfaces = listOf(cone)).volume, 0.1)
        }
    }

    private companion object {
        const val COUNT = 60
        const val STEPS = 150
    }
}
