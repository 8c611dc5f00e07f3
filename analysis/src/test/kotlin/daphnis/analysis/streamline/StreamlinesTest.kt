package daphnis.analysis.streamline

import daphnis.analysis.insitu.State
import daphnis.analysis.onEpicycles
import daphnis.analysis.order.RadialKey
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI

class StreamlinesTest {
    private val omega = 0.7
    private val sheet = HillSheet(Box.centred(20.0, 400.0, 2.0), omega, radiallyOpen = true)

    /**
     * Guiding centres on a lattice, all in one wave of wavelength 200 along the orbit whose crests lean by [lean]
     * radians a length of X.
     */
    private fun wave(e: Double, lean: Double): State = onEpicycles(
        List(100 * 400) {
            val gx = (it / 400 + 0.5) / 100 * 10 - 5
            val y = (it % 400 + 0.5) - 200
            Epicycle(gx, y, e, 2 * PI * y / 200 + lean * gx, 0.3, it * 0.1)
        },
        sheet,
        omega,
    )

    @Test
    fun `a drawn sine streamline comes back with its amplitude, wavelength, phases and q`() {
        val lines = Streamlines.of(wave(0.5, 0.4), slabs = 100, groups = 20, RadialKey.GUIDING_CENTRE)
        for (group in 2..17) {
            for (slab in 2..97) {
                val k = lines.at(slab, group)
                assertEquals(0.5, lines.meanE[k], 1e-12)
                assertEquals(0.3, lines.meanI[k], 1e-12)
                assertEquals(0.5, lines.forcedE[k], 0.005)
                val phase = 2 * PI * lines.meanY[k] / 200 + 0.4 * lines.guidingX[k]
                assertEquals(lines.guidingX[k] - 0.5 * Math.cos(phase), lines.meanX[k], 0.03)
                // |d(e exp(iφ))/dX| = e · dφ/dX.
                assertEquals(0.5 * 0.4, lines.q[k], 0.025)
                // dx/dX = 1 + e (dφ/dX) sin φ.
                assertEquals(0.5 * (1 + 0.2 * Math.sin(phase)), lines.spacing[k], 0.2)
                if (slab > 2) {
                    assertEquals(2 * PI * 4 / 200, lines.phase[k] - lines.phase[lines.at(slab - 1, group)], 0.04)
                }
            }
        }
    }

    @Test
    fun `groups are of equal count and those of a plain sort`() {
        val state = uniform(3000, sheet, omega = omega) { 0.1 * it.nextGaussian() }
        val p = state.population
        val lines = Streamlines.of(state, slabs = 10, groups = 7, RadialKey.X)
        assertEquals(3000, lines.count.sum())
        for (slab in 0 until 10) {
            val members = (0 until p.size).filter { ((p.y[it] + 200) / 40).toInt() == slab }.sortedBy { p.x[it] }
            for (group in 0 until 7) {
                val mine = members.subList(members.size * group / 7, members.size * (group + 1) / 7)
                val k = lines.at(slab, group)
                assertEquals(mine.size, lines.count[k])
                assertEquals(mine.map { p.x[it] }.average(), lines.meanX[k], 1e-12)
                assertEquals(mine.map { p.y[it] }.average(), lines.meanY[k], 1e-11)
                assertEquals(p.x[mine.first()], lines.minX[k])
                assertEquals(p.x[mine.last()], lines.maxX[k])
                val inner = lines.meanX[lines.at(slab, maxOf(group - 1, 0))]
                val outer = lines.meanX[lines.at(slab, minOf(group + 1, 6))]
                val width = if (group == 0 || group == 6) outer - inner else (outer - inner) / 2
                val excess = (if (group == 0 || group == 6) 2.0 / 3 else 5.0 / 12) - 1.0 / 7
                assertEquals(
                    mine.size * PI * 0.01 / (width * 40) * (1 - excess / mine.size),
                    lines.opticalDepth[k],
                    1e-12,
                )
                assertEquals(mine.map { 4 * p.x[it] + 2 * p.vy[it] / omega }.average(), lines.guidingX[k], 1e-11)
            }
        }
    }

    @Test
    fun `an empty slab, one particle, particles in one place and no frame are no trouble`() {
        val one = Streamlines.of(onEpicycles(listOf(Epicycle(1.0, 150.0, 0.0, 0.0)), sheet, omega), 4, 3)
        assertEquals(1, one.count.sum())
        assertTrue(one.meanX[one.at(0, 0)].isNaN())
        assertTrue(one.q.all { it.isNaN() })
        val heap =
            Population(
                DoubleArray(9) {
                    1.0
                },
                DoubleArray(9),
                DoubleArray(9),
                DoubleArray(9),
                DoubleArray(9),
                DoubleArray(9),
                DoubleArray(9) { 0.1 },
                DoubleArray(9) { 1.0 },
            )
        val same = Streamlines.of(State(heap, Open, 0.0), 2, 3)
        assertEquals(9, same.count.sum())
        assertTrue(same.opticalDepth.all { it.isNaN() } && same.forcedE.all { it.isNaN() })
        assertEquals(0, Streamlines.of(uniform(0, sheet), 2, 2).count.sum())
    }
}
