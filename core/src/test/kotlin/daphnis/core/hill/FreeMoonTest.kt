package daphnis.core.hill

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Open
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.force.Force
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/** Moons that feel the ring: what they and the ring keep together, and how they recede. */
class FreeMoonTest {
    private val orbits = OrbitalFrequencies(1.0, 0.95, 1.04)

    /** 150 spheres in a ring 8 wide, 40 along the orbit, which collide. */
    private fun ring(): Population {
        val random = SeededRandom(7)
        val count = 150
        fun near(place: (Int) -> Double) = DoubleArray(count) { place(it) + random.nextDouble(-0.2, 0.2) }
        val x = near { -4 + (it % 10) * 0.9 }
        val vy = DoubleArray(count) { -orbits.shearRate * x[it] + 0.02 * random.nextGaussian() }
        fun small() = DoubleArray(count) { 0.02 * random.nextGaussian() }
        return Population(
            x,
            near { -20 + (it / 10) * 2.7 },
            near { 0.0 },
            small(),
            vy,
            small(),
            DoubleArray(count) { 0.15 },
            DoubleArray(count) { 0.01 + 0.001 * (it % 7) },
        )
    }

    private fun moons() = listOf(
        Satellite(3.0, Epicycle(-6.0, -9.0, 0.4, 1.0), orbits, softening = 0.1, mass = 3.0),
        Satellite(2.0, Epicycle(7.0, 9.0, 0.0, 0.0, 0.3, 2.0), orbits, softening = 0.1, mass = 2.0),
    )

    private fun simulation(p: Population, forces: List<Force>, restitution: Double, dt: Double) = Simulation(
        p,
        Open,
        CollisionForcing(ConstantRestitution(restitution), engine = SerialEngine()),
        FixedTimeStep(dt),
        forces + HillFrame(orbits),
    )

    /** Σ m, and Σ m times X, Y, e cos φ, e sin φ, i cos ζ, i sin ζ of ring and moons at [time]. */
    private fun centre(p: Population, moons: List<Satellite>, time: Double): DoubleArray {
        val sum = DoubleArray(7)
        fun add(mass: Double, it: Epicycle) {
            val numbers = doubleArrayOf(
                1.0,
                it.guidingX,
                it.guidingY,
                it.e * cos(it.phase),
                it.e * sin(it.phase),
                it.i * cos(it.verticalPhase),
                it.i * sin(it.verticalPhase),
            )
            for (n in sum.indices) sum[n] += mass * numbers[n]
        }
        for (k in 0 until p.size) {
            add(p.mass[k], Epicycle.of(p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k], orbits))
        }
        for (moon in moons) add(moon.mass, moon.orbit(time))
        return sum
    }

    @Test
    fun `the centre of mass of ring and moons moves as a free particle, and angular momentum stays`() {
        val p = ring()
        val moons = moons()
        val start = centre(p, moons, 0.0)
        val simulation = simulation(p, moons, 0.5, 0.02)
        val x = moons.map { it.orbit.guidingX }
        repeat(1500) { simulation.advance() }
        val t = simulation.time
        val end = centre(p, moons, t)
        assertTrue(simulation.collisions!!.counters.collisions > 100) {
            "${simulation.collisions!!.counters.collisions}"
        }
        for ((k, moon) in moons.withIndex()) assertTrue(abs(moon.orbit.guidingX - x[k]) > 1e-3) { "${moon.orbit}" }
        assertEquals(start[1], end[1], 1e-12 * start[0], "Σ m X")
        assertEquals(start[2] - orbits.shearRate * start[1] * t, end[2], 1e-10 * start[0], "Σ m Y")
        for ((of, rate) in listOf(3 to orbits.kappa, 5 to orbits.nu)) {
            val (c, s) = cos(rate * t) to sin(rate * t)
            assertEquals(c * start[of] - s * start[of + 1], end[of], 1e-11 * start[0])
            assertEquals(s * start[of] + c * start[of + 1], end[of + 1], 1e-11 * start[0])
        }
    }

    /** Hill's energy of ring and moons with that between them, after an encounter. */
    private fun energyError(dt: Double): Double {
        val p = ring()
        val moons = moons()
        val simulation = simulation(p, moons, 1.0, dt)
        fun energy(): Double = p.kineticEnergy() + moons.sumOf { it.energy } +
            simulation.forces.sumOf { it.potentialEnergy(p, simulation.boundary, simulation.time) }
        val start = energy()
        val end = energy().let {
            while (simulation.time < 12) simulation.advance()
            energy()
        }
        assertTrue(simulation.collisions!!.counters.collisions > 30) {
            "${simulation.collisions!!.counters.collisions}"
        }
        return (end - start) / moons.sumOf { abs(it.energy) }
    }

    private fun Population.kineticEnergy() =
        (0 until size).sumOf { mass[it] * (vx[it] * vx[it] + vy[it] * vy[it] + vz[it] * vz[it]) / 2 }

    @Test
    fun `Hill's energy of ring and moons is constant up to the square of the step`() {
        val errors = listOf(0.02, 0.01, 0.005).map { abs(energyError(it)) }
        assertTrue(errors[0] < 2e-3 && errors[2] < errors[0] / 16) { "$errors" }
    }

    /**
     * A particle that passes at the distance b takes e and, since (X² − b²) · 3/4 = e², moves away by 2e²/(3b), with the
     * impulse e = 2.2396 μ a³/b² (Goldreich & Tremaine 1980; here with the measured factor of [SatelliteWakeTest]).
     */
    @Test
    fun `a moon beside a ring recedes by what the ring takes`() {
        val kepler = OrbitalFrequencies(1.0)
        val (b, n) = 10.0 to 60
        val mass = 1e-3
        val far = 4000.0
        val y = DoubleArray(n) { far + (it - (n - 1) / 2.0) * 3 * PI * b / n }
        val p = Population(
            DoubleArray(n) { b },
            y,
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n) { -1.5 * b },
            DoubleArray(n),
            DoubleArray(n) { 1e-3 },
            DoubleArray(n) { mass },
        )
        val moon = Satellite(3.0, Epicycle(0.0, 0.0, 0.0, 0.0), kepler, mass = 30.0)
        val simulation = Simulation(p, Open, null, FixedTimeStep(0.01), listOf(moon, HillFrame(kepler)))
        while (simulation.time < 2 * far / (1.5 * b)) simulation.advance()
        val e = 1.0084 * 2.2396 * 3.0 / (b * b)
        val expected = -n * mass / moon.mass * 2 * e * e / (3 * b)
        assertEquals(1.0, moon.orbit.guidingX / expected, 1e-4)
    }

    @Test
    fun `a moon that feels nothing keeps its orbit, and a light one gives way`() {
        val p = ring()
        val kept = Satellite(3.0, Epicycle(-6.0, -9.0, 0.4, 1.0), orbits)
        simulation(p, listOf(kept), 0.5, 0.02).use { it.advance() }
        assertEquals(0.0, kept.epoch)
        assertEquals(0.0, kept.energy)
        assertEquals(0, kept.carried.size)
        assertThrows(IllegalArgumentException::class.java) { Satellite(3.0, kept.orbit, orbits, mass = 0.0) }
        assertThrows(IllegalArgumentException::class.java) {
            Satellite(3.0, kept.orbit, OrbitalFrequencies(1.0, verticalFactor = 0.0), mass = 1.0)
        }
        assertThrows(IllegalArgumentException::class.java) { SatelliteSurface(Open, moons()[0], 1.0) }
        assertThrows(IllegalArgumentException::class.java) {
            Satellite(3.0, Epicycle(Double.NaN, 0.0, 0.0, 0.0), orbits)
        }
        assertThrows(IllegalArgumentException::class.java) { moons()[0].carried = DoubleArray(2) }
    }

    @Test
    fun `what a moon carries, put into another one, goes on with the same bits`() {
        val moons = moons()
        val p = ring()
        simulation(p, moons, 0.5, 0.02).use { one -> repeat(40) { one.advance() } }
        for (moon in moons) {
            val spec = SatelliteSpec(mass = 1.0, x = 0.0, y = 0.0, feelsRing = true)
                .beginningWith(moon.carried.asList()) as SatelliteSpec
            val other = Satellite(3.0, spec.orbit, orbits, softening = 0.1, mass = moon.mass, epoch = spec.epoch)
            assertArrayEquals(moon.carried, other.carried)
            assertArrayEquals(moon.state(7.0), other.state(7.0))
        }
    }
}
