package daphnis.analysis.insitu

import daphnis.analysis.correlation.PairCorrelation
import daphnis.analysis.correlation.StructureFactor
import daphnis.analysis.occultation.RayCasting
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.uniform
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.hill.HillSheet
import daphnis.core.population.VelocityMoments
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.pow
import kotlin.math.sin
import kotlin.math.sqrt

@Tag("jdk-neutral")
class AveragesTest {
    @Test
    fun `averages of a run that was stopped and resumed are those of one in one go`(@TempDir home: Path) {
        val first = Measure { doubleArrayOf(it.population.vx[it.population.indexOf(0)], it.time) }
        fun averages() = Averages(first, every = 2)
        val scenario = BuiltIn.scenario("elastic-gas", listOf("particles.count=50", "until=2", "timeStep.dt=0.1"))
        fun start(name: String, kept: Averages) =
            Run.start(scenario, "gas", home.resolve(name), outputs = mapOf("averages" to kept))
        val whole = averages()
        start("whole", whole).use { it.execute() }
        assertEquals(11, whole.size)
        start("broken", averages()).use { run -> run.execute(cancelled = { run.simulation.step >= 7 }) }
        val resumed = averages()
        Run.resume(home.resolve("broken"), outputs = mapOf("averages" to resumed)).use { it.execute() }
        for (k in 0..1) assertArrayEquals(whole.series(k), resumed.series(k))
    }

    private val box = Box.centred(10.0, 12.0, 8.0)

    /**
     * Holds averages over 64 states of [count] particles, 200 times, against [truth]: of the given [numbers] of the
     * measure, or what follows from each.
     */
    private fun hold(
        name: String,
        measure: Measure,
        numbers: IntRange,
        boundary: BoundaryConditions,
        count: Int,
        truth: Double,
        of: (BlockAverage) -> BlockAverage = { it },
    ) {
        var covered = 0
        var sum = 0.0
        repeat(REALISATIONS) { seed ->
            val averages = Averages(measure)
            repeat(64) {
                averages.add(
                    uniform(count, boundary, seed = 1000L * seed + it, radius = 0.3) { r ->
                        0.5 *
                            r.nextGaussian()
                    },
                )
            }
            for (k in numbers) {
                val a = of(averages.average(k))
                sum += a.mean
                if (abs(a.mean - truth) <= a.error) covered++
            }
        }
        val all = REALISATIONS * numbers.count()
        // With 200 realisations a share of 0.68 scatters by 0.033.
        assertTrue(covered / all.toDouble() in 0.60..0.75) { "$name: $covered of $all" }
        assertEquals(truth, sum / all, 0.006 * truth) { name }
    }

    @Tag("thorough")
    @Test
    fun `structure, occultation and moments of states cover the truth in 60 to 75 percent`() {
        val hill = HillSheet(box, 1.0)
        val sheared = LeesEdwards(box, 2.0)
        val b = 0.5
        val clear = (1 - PI * 0.09 / sin(b) / 120).pow(20)
        val moments = Measure { s ->
            VelocityMoments.of(s.population, s.boundary.meanFlow).let {
                it.moments +
                    doubleArrayOf(it.scaleHeight)
            }
        }
        hold("pair correlation", PairCorrelation(3.0, 3), 0..2, sheared, 60, 1.0)
        hold("structure factor", StructureFactor(3.0, 3), 1..2, sheared, 20, 1.0)
        hold("transmission", RayCasting(b, rays = 64).transmission(), 0..0, hill, 20, clear)
        val rays = RayCasting(b, rays = 64)
        hold("optical depth", rays.transmission(), 0..0, hill, 20, -sin(b) * ln(clear)) { rays.depth(it) }
        hold("velocity moments", moments, 0..2, sheared, 300, 0.25)
        hold("scale height", moments, 6..6, hill, 300, 8 / sqrt(12.0))
    }

    @Test
    fun `averages of plain measures leave NaN out, and refuse another width`() {
        var k = 0
        val averages = Averages({ doubleArrayOf(if (k++ % 2 == 0) Double.NaN else 3.0, k.toDouble()) })
        repeat(40) { averages.add(uniform(1, HillSheet(box, 1.0))) }
        assertEquals(20, averages.average(0).count)
        assertEquals(3.0, averages.average(0).mean)
        assertEquals(2, averages.width)
        val growing = Averages({ DoubleArray(++k) })
        growing.add(uniform(1, HillSheet(box, 1.0)))
        assertThrows(IllegalStateException::class.java) { growing.add(uniform(1, HillSheet(box, 1.0))) }
    }

    @Test
    fun `no state and one state have no error`() {
        val none = Averages(RayCasting(0.5, rays = 16).transmission())
        assertTrue(none.size == 0 && none.width == 0)
        none.add(uniform(5, HillSheet(box, 1.0)))
        assertTrue(none.average(0).mean in 0.5..1.0)
        assertFalse(none.average(0).isLevelled)
        assertEquals(none.series(0)[0], none.average(0).mean)
    }

    private companion object {
        const val REALISATIONS = 200
    }
}
