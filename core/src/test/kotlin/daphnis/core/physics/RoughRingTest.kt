package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.engine.CollisionForcing
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.population.SpinSums
import daphnis.core.population.VelocityMoments
import daphnis.core.run.CollisionStatistics
import daphnis.core.surface.BridgesRestitution
import daphnis.core.surface.ConstantRoughness
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.ln
import kotlin.math.pow
import kotlin.math.sqrt

/** Rough spheres in patches of rings: Ω = 1, radius 1, no gravity, the 0.34 law. Spins are relative to the frame. */
@Tag("physics")
class RoughRingTest {
    /**
     * A patch with the averages of a run.
     *
     * @param unit 1 unit of speed, r Ω, in cm/s: 0.01948 is a ring of spheres of 1 m, and with less the random speeds are
     *   many r Ω
     * @param sigma of each velocity component at the start
     */
    private inner class Patch(
        private val radii: DoubleArray,
        depth: Double,
        unit: Double,
        sigma: Double,
        beta: Double,
        seed: Long,
        private val stepsPerOrbit: Int,
    ) {
        private val count = radii.size
        private val edge = sqrt(radii.sumOf { PI * it * it } / depth)
        private val box = Box.centred(edge, edge, 16.0 + 8 * depth + 4 * sigma)
        private val sheet = HillSheet(box, 1.0)
        private val forcing = CollisionForcing(
            BridgesRestitution(0.34, -0.234, unit),
            recordCollisions = true,
            roughness = ConstantRoughness(beta),
        )
        val simulation: Simulation = Simulation(
            start(radii, sigma, SeededRandom(seed)),
            sheet,
            forcing,
            FixedTimeStep(2 * PI / stepsPerOrbit),
            listOf(HillFrame(1.0)),
        )

        var statistics = CollisionStatistics()
        private val spins = SpinSums()

        // Since [restart].
        private var states = 0
        private var rotating = 0.0
        private var spinning = 0.0
        private var stress = 0.0
        private val c = DoubleArray(6)
        private val spinSquares = DoubleArray(count)
        private val speedSquares = DoubleArray(count)

        private fun start(radii: DoubleArray, sigma: Double, random: SeededRandom): Population {
            val p = RandomPlacement().place(radii, box, booleanArrayOf(false, false, true), random)
            fun gauss() = DoubleArray(count) { sigma * random.nextGaussian() }
            val vy = gauss().also { for (k in it.indices) it[k] -= 1.5 * p.x[k] }
            fun none() = DoubleArray(count)
            return Population(p.x, p.y, p.z, gauss(), vy, gauss(), radii, DoubleArray(count) { radii[it].pow(3) })
                .withSpin(none(), none(), none())
        }

        /** Runs for [orbits]. */
        fun run(orbits: Double) {
            repeat((orbits * stepsPerOrbit).toInt()) {
                simulation.advance()
                statistics.write(simulation)
                if (simulation.step % EVERY == 0L) sample()
            }
        }

        /** Forgets what was measured so far. */
        fun restart() {
            statistics = CollisionStatistics(from = simulation.time)
            states = 0
            rotating = 0.0
            spinning = 0.0
            stress = 0.0
            for (column in listOf(c, spinSquares, speedSquares)) column.fill(0.0)
        }

        private fun sample() {
            val p = simulation.population
            val m = VelocityMoments.of(p, sheet.meanFlow, OrbitalFrequencies(1.0))
            spins.take(p)
            states++
            rotating += spins.temperature
            spinning += spins.mean(2)
            stress += m.kinetic[VelocityMoments.XY]
            for (k in c.indices) c[k] += m.moments[k]
            for (k in 0 until p.size) {
                val vy = p.vy[k] + 1.5 * p.x[k]
                spinSquares[p.id[k]] += p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k]
                speedSquares[p.id[k]] += p.vx[k] * p.vx[k] + vy * vy + p.vz[k] * p.vz[k]
            }
        }

        /** E_rot/E_kin, of peculiar velocities. */
        val ratio: Double get() = 3 * rotating / (c[0] + c[1] + c[2])

        /** Mean ω_z/Ω in the frame. */
        val spin: Double get() = spinning / states

        /** ⟨c_a c_b⟩: xx, yy, zz, xy. */
        val moments: List<Double> get() = c.map { it / states }

        /** 2.25 Ω² ν / dissipation. The work against the shear is that of momentum along the orbit, carried across it. */
        val balance: Double
            get() {
                val mass = simulation.population.mass.sum()
                val time = simulation.time - statistics.from
                return 1.5 * (stress / states + statistics.virial[YX] / time / mass) /
                    (statistics.dissipated / time / mass)
            }

        /** Slope of ln of the rms spin over ln of the radius. */
        val slopeOfSpin: Double get() = slope(radii, spinSquares)

        /** The same of the rms speed. */
        val slopeOfSpeed: Double get() = slope(radii, speedSquares)
    }

    /** Slope of ln of the root mean of [squares] over ln of the radius, by classes of equal [radii]. */
    private fun slope(radii: DoubleArray, squares: DoubleArray): Double {
        val classes = radii.indices.groupBy { radii[it] }
        val x = classes.keys.map { ln(it) }
        val y = classes.values.map { ids -> ln(ids.sumOf { squares[it] } / ids.size) / 2 }
        return x.indices.sumOf { (x[it] - x.average()) * y[it] } / x.sumOf { (it - x.average()).pow(2) }
    }

    private val seeds get() = if (fullPhysics) 1L..3L else 1L..1L

    private fun equal(count: Int) = DoubleArray(count) { 1.0 }

    @Test
    fun `a hot ring of few spheres shares its energy with the spins, and spins with the flow`() {
        for (beta in if (fullPhysics) listOf(-0.9, -0.5, 0.0, 0.5) else listOf(0.0)) {
            val sigma = mapOf(-0.9 to 22.0, -0.5 to 10.0, 0.0 to 6.0, 0.5 to 6.0).getValue(beta)
            val patches = seeds.map { seed ->
                Patch(equal(if (fullPhysics) 1500 else 600), 0.1, 0.001, sigma, beta, seed, 100).apply {
                    run(if (fullPhysics) 40.0 else 20.0)
                    restart()
                    run(if (fullPhysics) 60.0 else 20.0)
                }
            }
            val moments = List(4) { k -> patches.map { it.moments[k] }.average() }
            val x = 1 + beta
            val isotropic = 2 * x / (14 - 5 * x)
            val name = "β = $beta, hot ring, τ = 0.1"
            val target = isotropic * Ellipsoid(moments).excess
            val bound = if (fullPhysics) 0.03 else 0.08
            assertPhysics("E_rot/E_kin, $name", target, patches.map { it.ratio }.average(), bound)
            assertPhysics(
                "⟨ω_z⟩/Ω, $name",
                Ellipsoid(moments).spin,
                patches.map { it.spin }.average(),
                if (fullPhysics) 0.1 else 0.2,
                relative = false,
            )
        }
    }

    @Test
    fun `surfaces of large and small spheres of a ring spin alike in comparison with their speed`() {
        val share = if (fullPhysics) 1.0 else 0.3
        val sizes = listOf(1.0, 1.5, 2.25, 3.375)
        val radii = sizes.flatMap { r -> List((1000 * share / (r * r)).toInt()) { r } }.toDoubleArray()
        val slopes = seeds.map { seed ->
            Patch(radii, 0.1, 0.001, 6.0, 0.0, seed, 100).run {
                run(if (fullPhysics) 40.0 else 20.0)
                restart()
                run(if (fullPhysics) 60.0 else 20.0)
                slopeOfSpin - slopeOfSpeed
            }
        }
        val bound = if (fullPhysics) 0.08 else 0.15
        assertPhysics("d ln (ω/c) / d ln r, β = 0.0, hot ring, τ = 0.1", -1.0, slopes.average(), bound)
    }

    @Test
    fun `a cold ring of rough spheres heats itself by as much as it loses`() {
        for (beta in if (fullPhysics) listOf(0.5, 1.0) else listOf(0.5)) {
            val patches = seeds.map { seed ->
                Patch(equal(if (fullPhysics) 1500 else 500), 0.5, 0.01948, 2.0, beta, seed, 200).apply {
                    run(10.0)
                    restart()
                    run(if (fullPhysics) 30.0 else 10.0)
                }
            }
            val name = "β = $beta, ring, τ = 0.5"
            val bound = if (fullPhysics) 0.01 else 0.03
            assertPhysics("2.25 Ω² ν / dissipation, $name", 1.0, patches.map { it.balance }.average(), bound)
            assertPhysics("⟨ω_z⟩/Ω, $name", HALF_VORTICITY, patches.map { it.spin }.average(), 0.25, relative = false)
        }
    }

    private companion object {
        const val EVERY = 10

        /** Σ Δp_y δ_x among the nine of [CollisionStatistics.virial]. */
        const val YX = 3

        /** Half of the vorticity of the mean flow in the frame, over Ω. */
        const val HALF_VORTICITY = -0.75
    }
}
