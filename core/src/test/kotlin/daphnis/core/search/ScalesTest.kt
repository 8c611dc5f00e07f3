package daphnis.core.search

import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The ends of what a step can be computed with: they belong to it, the next double does not. */
class ScalesTest {
    private fun assertRefused(part: String, check: () -> Unit) {
        val message = assertThrows(IllegalArgumentException::class.java, check).message!!
        assertTrue(part in message && "choose other units" in message) { message }
    }

    @Test
    fun `speeds up to 1e70, radii from 1e-70`() {
        Scales.requireSpeeds(1e70, 1.0, 1.0)
        assertRefused("fastest sphere") { Scales.requireSpeeds(Math.nextUp(1e70), 1.0, 1.0) }
        Scales.requireSpeeds(0.0, 1 / 1e70, 1e-20)
        assertRefused("smallest radius") { Scales.requireSpeeds(0.0, Math.nextDown(1 / 1e70), 1e-20) }
    }

    @Test
    fun `a radius squared is at least 1e-130 of the step`() {
        Scales.requireSpeeds(0.0, 1e-65, 1e-4)
        Scales.requireSpeeds(0.0, 1.0, 1e120)
        assertRefused("too far apart") { Scales.requireSpeeds(0.0, 1e-65, 2.0) }
        assertRefused("too far apart") { Scales.requireSpeeds(0.0, 1e-30, 1e71) }
    }

    @Test
    fun `places and radii up to 1e70 either way`() {
        val beyond = Math.nextUp(1e70)
        Scales.requireLengths(0, -1e70, 1e70, 1e70)
        assertRefused("along x") { Scales.requireLengths(0, -beyond, 1.0, 1.0) }
        assertRefused("along y") { Scales.requireLengths(1, 0.0, beyond, 1.0) }
        assertRefused("along z") { Scales.requireLengths(2, 0.0, 1.0, beyond) }
    }
}
