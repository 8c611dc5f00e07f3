package daphnis.core.cluster.bricks

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.search.Grid
import daphnis.core.search.GridExtent
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

@Timeout(120)
class BodiesTest {
    private val box = Box.centred(40.0, 20.0, 12.0)

    /** A moonlet at ([x], 0, 0) among small spheres on a lattice, some of which touch it nearly. */
    private fun moonlet(x: Double, seed: Long = 1): Population {
        val random = SeededRandom(seed)
        val spheres = ArrayList<Sphere>()
        fun v() = random.nextGaussian()
        spheres += Sphere(x = x, vx = 0.1, r = 4.0, m = 500.0)
        for (i in 0 until 33) {
            for (j in 0 until 16) {
                for (k in 0 until 9) {
                    val s = Sphere(-19.5 + 1.2 * i, -9.3 + 1.2 * j, -5.0 + 1.2 * k, v(), v(), v(), r = 0.4, m = 0.1)
                    val dx = box.lengthBetween(s.x - x)
                    if (dx * dx + s.y * s.y + s.z * s.z > 4.41 * 4.41) spheres += s
                }
            }
        }
        return populationOf(*spheres.toTypedArray())
    }

    private fun Box.lengthBetween(d: Double) = d - length(0) * Math.rint(d / length(0))

    @Test
    fun `a moonlet on a cut, beside one, and on the face of the box change no bit`() {
        val boundary = Periodic(box)
        for (at in listOf(0.0, 1.0, 4.5, 10.0, -19.9)) {
            val serial =
                Simulation(moonlet(at), boundary, CollisionForcing(ConstantRestitution(0.5)), FixedTimeStep(DT))
            serial.advance()
            val p = moonlet(at)
            val redone = cutAt(p, boundary, doubleArrayOf(-12.0, 0.0, 12.0))
            boundary.endStep(p, DT)
            assertEquals(stateDigest(serial.population), stateDigest(p)) { "moonlet at $at, $redone redone" }
            // Cut through, the halo has to become as wide as the moonlet.
            if (at == 0.0) assertTrue(redone > 0) { "a moonlet on a cut needs no wide halo" }
        }
    }

    /** A step of [p] in slabs between [planes] along x; how often it was redone. */
    private fun cutAt(p: Population, boundary: BoundaryConditions, planes: DoubleArray): Long {
        val counters = CollisionCounters()
        val step = CollisionStep(p, boundary, CollisionLaw(ConstantRestitution(0.5)), counters)
        step.duration = DT
        val whole = PreparedStep().also { it.measure(step) }
        val margins = HaloMargins().also { it.diameter = 0.8 }
        val crew = BrickCrew(whole, margins)
        crew.settle(Territory(Cuts(listOf(planes, DoubleArray(0), DoubleArray(0)), boundary), boundary, 1))
        val bodies = bodiesOf(p, 0.4)
        assertEquals(1, bodies.size)
        val extent = GridExtent().also { it.measure(p, boundary, Grid.WHOLE, InlineLoop) }
        crew.compute(p.size, bodies, extent, InlineLoop)
        crew.collect(null)
        crew.store(InlineLoop)
        return crew.redone
    }

    @Test
    fun `cuts keep away from a moonlet, across the face of the box too, and halos need no room for it then`() {
        for ((boundary, at) in listOf(
            Periodic(box) to 0.0,
            Periodic(box) to 19.0,
            Periodic(box) to -20.0,
            Open to 3.0,
        )) {
            val p = moonlet(at)
            val bodies = bodiesOf(p, 0.41)
            assertEquals(0.4, bodies.ordinary)
            val clearance = doubleArrayOf(1.0, 1.0, 1.0)
            val territory =
                Territory(CutPlaces(p, boundary).choose(BrickDivision(4, 1, 1), bodies, clearance), boundary, 1)
            assertTrue(territory.size >= 3) { "${territory.size} bricks" }
            for (brick in 0 until territory.size) {
                val d = territory.lower(0, brick) - at
                val distance = if (boundary === Open) Math.abs(d) else Math.abs(box.lengthBetween(d))
                assertTrue(distance >= 5.0 - 1e-9) { "moonlet at $at, plane $distance away" }
            }
            assertEquals(List(territory.size) { 0.4 }, bodies.edges(territory).asList())
        }
    }

    @Test
    fun `the part of a body that sticks out counts where a cut is near`() {
        val p = moonlet(1.0)
        val bodies = bodiesOf(p, 0.41)
        val cuts = Cuts(listOf(doubleArrayOf(-10.0, 0.0), DoubleArray(0), DoubleArray(0)), Periodic(box))
        assertEquals(listOf(0.4, 3.0), bodies.edges(Territory(cuts, Periodic(box), 1)).asList())
    }

    private companion object {
        const val DT = 0.4
    }
}
