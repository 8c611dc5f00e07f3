package daphnis.core.scenario

import daphnis.core.boundary.Box
import daphnis.core.format.Snapshot
import daphnis.core.hill.HillSheet
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class BoxDifferenceTest {
    /** Images slide along y by 90 in a unit of time. */
    private val sheet = HillSheet(Box.centred(60.0, 72.0, 2.0), 1.0)

    private fun problem(time: Double, offset: Double, normalAxis: Int) =
        BoxDifference.of(sheet, state(offset, normalAxis), time, "a file")?.problem.orEmpty()

    private fun state(offset: Double, normalAxis: Int) = Snapshot(
        0L, 0.0, doubleArrayOf(60.0, 72.0, 2.0), booleanArrayOf(true, true, false), offset, IntArray(0),
        Array(3) { DoubleArray(0) }, Array(3) { DoubleArray(0) }, DoubleArray(0), DoubleArray(0),
        normalAxis = normalAxis, slideAxis = 1 - normalAxis,
    )

    @Test
    fun `an upright box is that of images that have slid by its edge along the slide, whichever axes it names`() {
        for (normalAxis in 0..1) {
            assertEquals("", problem(72 / 90.0, 0.0, normalAxis)) { "$normalAxis" }
            assertEquals("", problem(7 * 72 / 90.0, 0.0, normalAxis)) { "$normalAxis" }
            // By the other edge, or by half of it.
            assertTrue("leans by 0.0" in problem(60 / 90.0, 0.0, normalAxis)) { "$normalAxis" }
            assertTrue("leans by 0.0" in problem(36 / 90.0, 0.0, normalAxis)) { "$normalAxis" }
        }
    }

    @Test
    fun `a box that leans the other way is another`() {
        val slid = checkNotNull(sheet.shear).offset(0.2)
        assertEquals("", problem(0.2, slid, 0))
        assertEquals("", problem(0.2, slid + 72, 0))
        assertTrue("along x across y" in problem(0.2, slid, 1))
        assertTrue("along y across x" in problem(0.0, slid, 0))
    }
}
