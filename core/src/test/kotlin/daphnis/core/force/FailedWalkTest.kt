package daphnis.core.force

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class FailedWalkTest {
    /** A loop whose second half fails when it [isBroken]. */
    private class HalfLoop : RangeLoop {
        var isBroken = false
        override val workers get() = 1

        override fun run(size: Int, grain: Int, body: RangeBody) {
            body.run(0, 0, size / 2)
            check(!isBroken) { "on purpose" }
            body.run(0, size / 2, size)
        }
    }

    @Test
    fun `accelerations that were half computed for another time are not taken for those of before`() {
        val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
        val p = randomSpheres(200, boundary, 4, 1.0) { 0.3 }
        val moved = p.copy().also { for (k in 0 until it.size) it.x[k] += 0.1 * k }
        val loop = HalfLoop()
        val gravity = SelfGravity(boundary, 1.0).also { it.useLoop(loop) }
        val before = gravity.accelerations(p, 0.0).map { it.copyOf() }
        loop.isBroken = true
        assertThrows(IllegalStateException::class.java) { gravity.accelerations(moved, 1.0) }
        loop.isBroken = false
        val again = gravity.accelerations(p, 0.0)
        for (axis in 0..2) assertArrayEquals(before[axis], again[axis])
    }
}
