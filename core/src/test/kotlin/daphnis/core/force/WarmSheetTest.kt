package daphnis.core.force

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sin
import kotlin.math.sqrt

/** Waves of a sheet without collisions whose spheres swing at random, under [RadialGravity]. */
class WarmSheetTest {
    private val box = Box.centred(1000.0, 40.0, 10.0)

    /**
     * ω/κ of a wave of a warm sheet: ω² = κ² − 2πGΣ|k| F, with the reduction factor F of a Gaussian of velocities, for
     * χ = k² σ_x²/κ² (Toomre 1964, ApJ 139, 1217; Binney & Tremaine 2008, Galactic Dynamics, section 6.2.3).
     */
    private fun warm(strength: Double, chi: Double): Double {
        fun reduction(s: Double): Double {
            val n = 2000
            val sum = (1 until n).sumOf { j ->
                val t = PI * j / n
                exp(-chi * (1 + cos(t))) * sin(s * t) * sin(t)
            }
            return (1 - s * s) / sin(PI * s) * sum * PI / n
        }
        var (low, high) = 0.01 to 0.999
        repeat(50) {
            val s = (low + high) / 2
            if (s * s < 1 - strength * reduction(s)) low = s else high = s
        }
        return low
    }

    /** The same of epicycles of a Gaussian of velocities around evenly spread guiding centres, all of which move alike. */
    private fun warmFrequency(mode: Int, strength: Double, chi: Double): Double {
        val (places, each) = 50 to 64
        val n = places * each
        val k = 2 * PI * mode / 1000
        val sigma = sqrt(chi) / k
        val size = DoubleArray(n) { sigma * sqrt(-2 * ln(1 - (it % each + 0.5) / each)) }
        val phase = DoubleArray(n) { 2 * PI * (it % each * 0.618034) }
        val guide = DoubleArray(n) { (it / each + 0.5) / places * 1000 - 500 }
        val moved = DoubleArray(n) { 0.5 * sin(k * guide[it]) }
        val p = Population(
            DoubleArray(n) { i ->
                (guide[i] - size[i] * cos(phase[i]) + moved[i]).let { it - 1000 * Math.rint(it / 1000) }
            },
            DoubleArray(n) { (it * 0.618034) % 1.0 * 40 - 20 },
            DoubleArray(n),
            DoubleArray(n) { size[it] * sin(phase[it]) },
            // 2x + v_y is half the guiding centre, for images those of their own.
            DoubleArray(n) { i ->
                val x = guide[i] - size[i] * cos(phase[i]) + moved[i]
                val boxes = Math.rint(x / 1000) * 1000
                guide[i] / 2 - 2 * x + 1.5 * boxes
            },
            DoubleArray(n),
            DoubleArray(n) { 0.01 },
            DoubleArray(n) { 1.0 },
        )
        val constant = strength / (2 * PI * k * n / (1000.0 * 40))
        val frame = OrbitalFrequencies(1.0)
        val sheet = HillSheet(box, frame)
        val forces = listOf(RadialGravity(sheet, constant, mode), HillFrame(frame))
        val simulation = Simulation(p, sheet, null, FixedTimeStep(0.02), forces)
        val zeros = ArrayList<Double>()
        var (before, timeBefore) = Double.NaN to 0.0
        while (zeros.size < 9) {
            simulation.advance()
            val a = (0 until n).sumOf { cos(k * p.x[it]) }
            if (before * a < 0) zeros += timeBefore + (simulation.time - timeBefore) * before / (before - a)
            before = a
            timeBefore = simulation.time
        }
        return PI * (zeros.size - 1) / (zeros.last() - zeros.first())
    }

    @Tag("thorough")
    @Test
    fun `waves of a warm sheet have the frequency that Toomre's reduction factor gives`() {
        for ((mode, strength, chi) in listOf(Triple(3, 0.6, 0.5), Triple(5, 0.9, 0.3), Triple(2, 0.5, 1.0))) {
            val seen = warmFrequency(mode, strength, chi)
            assertEquals(warm(strength, chi), seen, 0.003) { "wave $mode" }
        }
    }
}
