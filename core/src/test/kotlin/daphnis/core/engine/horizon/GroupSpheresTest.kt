package daphnis.core.engine.horizon

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.prepare
import daphnis.core.collision.StepRows
import daphnis.core.collision.contactTime
import daphnis.core.randomSpheres
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class GroupSpheresTest {
    private val boundary = LeesEdwards(Box.centred(8.0, 8.0, 8.0), 0.3)
    private val gas = randomSpheres(60, boundary, 5, 1.0) { 0.3 + 0.2 * it.nextDouble() }
    private val images = Images().apply { prepare(boundary, 1.7) }
    private val n = gas.size

    @Test
    fun `spheres without rows touch when their rows would, to the bit, and get none by being asked`() {
        // Index in the population by index, slot by index: as in a second window of the first step of an epoch.
        val order = IntArray(n) { (it * 7 + 3) % n }
        val slotAt = IntArray(n) { (it * 11 + 5) % n }
        val indexAt = IntArray(n).also { for (k in slotAt.indices) it[slotAt[k]] = k }
        for (isLater in listOf(false, true)) {
            val places = SlotPlaces().apply { reserve(n) }
            val source = RowSource()
            source.begin(gas, n, order, 1.0, false)
            val spheres = GroupSpheres(places, source)
            spheres.begin(1.0, 0.0, 1.0, false)
            if (isLater) {
                source.goOn(indexAt, slotAt)
                spheres.goOn(0.5, 1.0)
            }
            val rows = StepRows()
            rows.begin(1.0, false, 0)
            for (slot in 0 until n) rows.include(gas, order[if (isLater) indexAt[slot] else slot])
            // Every third sphere has a row, which has moved on with another velocity.
            for (slot in 0 until n step 3) {
                val p = spheres.placeOf(slot) * StepRows.STRIDE
                for (state in listOf(spheres.rows.state to p, rows.state to slot * StepRows.STRIDE)) {
                    state.first[state.second + StepRows.VX] = -0.7
                    state.first[state.second + StepRows.TIME] = 0.01 * slot
                }
            }
            var touching = 0
            for (i in 0 until n) {
                for (j in 0 until n) {
                    for (code in listOf(0, Images.code(1, 0, 0), Images.code(0, -1, 1))) {
                        val expected = contactTime(rows, i, j, code, images)
                        val time = spheres.contactTime(i, j, code, images)
                        assertEquals(expected.toRawBits(), time.toRawBits()) { "$i, $j, $code" }
                        if (time < 1e3) touching++
                    }
                }
            }
            assertTrue(touching > 40) { "$touching" }
            assertEquals((n + 2) / 3, spheres.rows.size)
        }
    }
}
