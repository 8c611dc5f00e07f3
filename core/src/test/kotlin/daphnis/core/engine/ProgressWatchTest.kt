package daphnis.core.engine

import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ProgressWatchTest {
    private val most = 100_000 + 100 * 7

    @Test
    fun `as many collisions as it allows while time stands still pass, one more is a collapse`() {
        val watch = ProgressWatch()
        watch.start(7, 2.0)
        // Within 1e-13 of the step.
        repeat(most) { watch.check(1.9e-13 * it / most, 5.0) }
        val e = assertThrows(CollapseException::class.java) { watch.check(1.9e-13, 5.0) }
        assertTrue("guard" in e.message.orEmpty()) { e.message }
    }

    @Test
    fun `any number pass while time goes on`() {
        val watch = ProgressWatch()
        watch.start(7, 2.0)
        repeat(3 * most) { watch.check(2.1e-13 * (it / (most / 2)), 0.0) }
    }
}
