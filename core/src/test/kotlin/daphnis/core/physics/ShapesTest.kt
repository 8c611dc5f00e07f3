package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.UniformAcceleration
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.run.WallStatistics
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.CoulombRoughness
import daphnis.core.wall.CylinderWall
import daphnis.core.wall.PlaneWall
import daphnis.core.wall.RoomSide
import daphnis.core.wall.SphereWall
import daphnis.core.wall.Wall
import daphnis.core.wall.WallFace
import daphnis.core.wall.WallMotion
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

/** Gases and grains between walls of other shapes: pressure, conserved quantities, loops, wedges. */
class ShapesTest {
    private val origin = listOf(0.0, 0.0, 0.0)
    private val alongX = listOf(1.0, 0.0, 0.0)
    private val all = booleanArrayOf(true, true, true)

    private fun gas(count: Int, walls: Walls, seed: Long, radius: Double): Population {
        val random = SeededRandom(seed)
        val radii = DoubleArray(count) { radius }
        val places = RandomPlacement().within(walls.walls.surfaces).place(radii, walls.box, all, random)
        fun gauss() = DoubleArray(count) { random.nextGaussian() }
        return Population(places.x, places.y, places.z, gauss(), gauss(), gauss(), radii, DoubleArray(count) { 1.0 })
    }

    private fun energy(p: Population, g: Double = 0.0) = (0 until p.size).sumOf {
        0.5 * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) + g * p.z[it]
    }

    /** Pressure times volume over N T, with the second virial coefficient, of what a gas gives to the first surface. */
    private fun pressure(surface: Wall, box: Box, area: Double, room: Double, seed: Long): Double {
        val walls = Walls(box, surfaces = listOf(surface))
        val p = gas(100, walls, seed, RADIUS)
        val forcing = CollisionForcing(ConstantRestitution(1.0), recordCollisions = true)
        val simulation = Simulation(p, walls, forcing, FixedTimeStep(0.5))
        val given = WallStatistics()
        val temperature = energy(p) / (1.5 * p.size)
        while (simulation.time < 400) {
            simulation.advance()
            given.write(simulation)
        }
        assertEquals(1.0, energy(p) / (1.5 * p.size) / temperature, 1e-11)
        for (k in 0 until p.size) assertTrue(surface.distance(p.x[k], p.y[k], p.z[k]) > RADIUS * (1 - 1e-9))
        // Second virial coefficient 2πσ³/3.
        val virial = 1 + p.size / room * 2 * Math.PI / 3 * 8 * RADIUS * RADIUS * RADIUS
        return given.surfaceImpulse(0) / area / 400 * room / (p.size * temperature) / virial
    }

    @Test
    fun `a thin gas presses on a plane, a cylinder and a sphere as its equation of state says`() {
        // Recorded because they move along themselves, which does nothing to smooth spheres. Lengths are of centres.
        val r = 6.0
        val edge = 10.0
        val belt = listOf(1.0, 0.0, -1.0)
        val plane = PlaneWall(origin, listOf(1.0, 0.0, 1.0), belt = belt)
        val drum = CylinderWall(origin, alongX, r + RADIUS, angularVelocity = 1.0)
        val vessel = SphereWall(origin, r + RADIUS, angularVelocity = listOf(1.0, 0.0, 0.0))
        val cube = Box.centred(edge, edge, edge)
        val c = edge - 2 * RADIUS
        // The corner that is cut off from the cube of centres, by a plane at the distance of a radius.
        val shift = RADIUS * sqrt(2.0)
        val half = c * (c - shift) * (c - shift) / 2
        val cases = listOf(
            { seed: Long -> pressure(plane, cube, c * (c - shift) * sqrt(2.0), half, seed) },
            { seed: Long ->
                val long = Box.centred(8.0, 13.0, 13.0)
                pressure(drum, long, 2 * Math.PI * r * (8 - 2 * RADIUS), Math.PI * r * r * (8 - 2 * RADIUS), seed)
            },
            { seed: Long ->
                val room = Box.centred(13.0, 13.0, 13.0)
                pressure(vessel, room, 4 * Math.PI * r * r, 4.0 / 3 * Math.PI * r * r * r, seed)
            },
        )
        for ((k, case) in cases.withIndex()) {
            val seeds = (1L..4L).map(case)
            val mean = seeds.average()
            val error = sqrt(seeds.sumOf { (it - mean) * (it - mean) } / 3 / 4)
            assertTrue(error < 0.02) { "case $k: error $error" }
            assertTrue(abs(mean - 1) < 4 * error + 0.003) { "case $k: $mean ± $error" }
        }
    }

    @Test
    fun `a gas that falls keeps its energy over 300 bounces however long the step`() {
        for (dt in listOf(0.03, 0.2, 0.8)) {
            val surfaces = listOf(
                listOf(SphereWall(origin, 3.0), SphereWall(origin, 0.7, RoomSide.OUTSIDE)),
                listOf(
                    CylinderWall(listOf(0.0, 0.2, 0.0), listOf(0.3, 1.0, 0.2), 3.0),
                    PlaneWall(listOf(0.0, 0.0, -0.5), listOf(0.2, 0.1, 1.0)),
                ),
            )
            for (shape in surfaces) {
                val walls = Walls(Box.centred(8.0, 8.0, 8.0), surfaces = shape)
                val p = gas(12, walls, 3, 0.2)
                val g = 1.0
                val forcing = CollisionForcing(ConstantRestitution(1.0))
                val simulation =
                    Simulation(p, walls, forcing, FixedTimeStep(dt), listOf(UniformAcceleration(0.0, 0.0, -g)))
                val before = energy(p, g)
                while (forcing.counters.wallCollisions < 300 * p.size) simulation.advance()
                assertEquals(before, energy(p, g), 1e-12 * 12) { "$shape, dt $dt" }
            }
        }
    }

    @Test
    fun `in a spherical vessel each free sphere keeps its angular momentum`() {
        val walls = Walls(Box.centred(8.0, 8.0, 8.0), surfaces = listOf(SphereWall(origin, 3.0)))
        val p = gas(1, walls, 5, 0.2)
        fun momentum() = doubleArrayOf(
            p.y[0] * p.vz[0] - p.z[0] * p.vy[0],
            p.z[0] * p.vx[0] - p.x[0] * p.vz[0],
            p.x[0] * p.vy[0] - p.y[0] * p.vx[0],
        )
        val before = momentum()
        val forcing = CollisionForcing(ConstantRestitution(1.0))
        val simulation = Simulation(p, walls, forcing, FixedTimeStep(0.7))
        while (forcing.counters.wallCollisions < 10_000) simulation.advance()
        for (k in 0..2) assertEquals(before[k], momentum()[k], 1e-12)
    }

    private enum class Start { SLIDING, ROLLING, CARRIED }

    /**
     * Whether a grain that starts at the bottom of a cylinder with v² = [part] g ρ comes around on the wall: where it
     * slides or rolls on a wall at rest, and where a wall that turns carries it.
     */
    private fun loops(part: Double, start: Start, factor: Double = 0.4): Boolean {
        val rho = 4.5
        val v = sqrt(part * rho)
        val turns = if (start == Start.CARRIED) v / rho else 0.0
        val drum = CylinderWall(
            origin,
            alongX,
            5.0,
            face = WallFace(restitution = 0.0),
            roughness = if (start == Start.SLIDING) null else CoulombRoughness(100.0, 0.0),
            angularVelocity = turns,
        )
        val walls = Walls(Box.centred(8.0, 10.0, 10.0), surfaces = listOf(drum))
        fun column(x: Double) = doubleArrayOf(x)
        val none = column(0.0)
        val smooth =
            Population(none, column(0.0), column(-rho), column(0.0), column(v), column(0.0), column(0.5), column(1.0))
        // Its surface moves with the wall where it touches.
        val spin = if (start == Start.ROLLING) -v / 0.5 else turns
        val p = if (start == Start.SLIDING) smooth else smooth.withSpin(column(spin), column(0.0), column(0.0))
        val forcing = CollisionForcing(ConstantRestitution(1.0), momentFactor = factor)
        val forces = listOf(UniformAcceleration(0.0, 0.0, -1.0))
        val simulation = Simulation(p, walls, forcing, FixedTimeStep(0.005), forces)
        while (simulation.time < 12) {
            simulation.advance()
            val far = sqrt(p.y[0] * p.y[0] + p.z[0] * p.z[0])
            if (far < rho - 0.05) return false
        }
        return true
    }

    @Test
    fun `a grain goes through a loop if it is fast enough, and one that rolls or is carried sooner`() {
        // v² = 5 gρ. One that rolls, with the moment of inertia q m r², is slower at the top by 4 gρ/(1 + q). What is
        // only a little too slow leaves the wall by less than is asked for here.
        assertTrue(loops(5.05, Start.SLIDING))
        assertTrue(!loops(4.6, Start.SLIDING))
        for (q in listOf(0.4, 2.0 / 3)) {
            for (start in listOf(Start.ROLLING, Start.CARRIED)) {
                assertTrue(loops(1 + 4 / (1 + q) + 0.05, start, q)) { "$start with $q" }
                assertTrue(!loops(1 + 4 / (1 + q) - 0.35, start, q)) { "$start with $q" }
            }
        }
    }

    @Test
    fun `a plastic grain stays in a wedge of two planes and in a bowl, with a bound on its bounces`() {
        val wedge = listOf(
            PlaneWall(origin, listOf(1.0, 0.0, 0.4), WallFace(restitution = 0.5)),
            PlaneWall(origin, listOf(-1.0, 0.0, 0.3), WallFace(restitution = 0.0)),
        )
        val bowl = listOf(SphereWall(listOf(0.0, 0.0, 2.0), 3.0, face = WallFace(restitution = 0.5)))
        for (shape in listOf(wedge, bowl)) {
            val walls = Walls(Box.centred(20.0, 20.0, 20.0), surfaces = shape)
            val p = gas(1, walls, 8, 0.3)
            p.x[0] = 0.0
            p.y[0] = 0.0
            p.z[0] = 3.0
            p.vx[0] = 1.0
            val forcing = CollisionForcing(ConstantRestitution(0.5), FloorSpeedGuard(1e-6))
            val forces = listOf(UniformAcceleration(0.0, 0.0, -1.0))
            val simulation = Simulation(p, walls, forcing, FixedTimeStep(0.01), forces)
            while (simulation.time < 60) simulation.advance()
            assertTrue(forcing.counters.wallCollisions < 600_000) { "${forcing.counters.wallCollisions} bounces" }
            for (s in shape) {
                val gap = s.distance(p.x[0], p.y[0], p.z[0]) - 0.3
                assertTrue(gap in -1e-12..1e-3) { "$s: gap $gap" }
            }
        }
    }

    @Test
    fun `a body that moves steadily through resting spheres throws them as two masses, one infinite, do`() {
        val speed = 0.5
        val face = WallFace(motion = WallMotion.Steady(speed))
        val body = SphereWall(listOf(-5.0, 0.0, 0.0), 1.0, RoomSide.OUTSIDE, face, along = alongX)
        val walls = Walls(Box.centred(40.0, 40.0, 40.0), surfaces = listOf(body))
        fun column(x: Double) = doubleArrayOf(x)
        val p = Population(
            column(0.0),
            column(0.9),
            column(0.0),
            column(0.0),
            column(0.0),
            column(0.0),
            column(0.5),
            column(1.0),
        )
        val forcing = CollisionForcing(ConstantRestitution(1.0), recordCollisions = true)
        val simulation = Simulation(p, walls, forcing, FixedTimeStep(1.0))
        val given = WallStatistics()
        while (simulation.time < 15) {
            simulation.advance()
            given.write(simulation)
        }
        // The normal is (0.8, 0.6, 0) · 1.5, and it leaves with 2 · 0.5 · 0.8 along it.
        assertEquals(0.8 * 0.8, p.vx[0], 1e-12)
        assertEquals(0.8 * 0.6, p.vy[0], 1e-12)
        assertEquals(0.32, given.given, 1e-12)
        assertEquals(0.8, given.surfaceImpulse(0), 1e-12)
    }

    private companion object {
        const val RADIUS = 0.1
    }
}
