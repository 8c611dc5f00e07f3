package daphnis.analysis.insitu

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PlaneImagesTest {
    private val box = Box.centred(10.0, 12.0, 8.0)

    @Test
    fun `images stand where the contact search has them, whichever axis slides`() {
        for (boundary in listOf(
            Periodic(box),
            HillSheet(box, 1.0),
            HillSheet(box, 1.0, true),
            LeesEdwards(box, 0.7),
            LeesEdwards(box, -0.7),
        )) {
            val images = PlaneImages(boundary, 0.83)
            val known = Images().also { it.prepare(boundary, 0.83) }
            for (ix in if (images.repeats(0)) -3..3 else 0..0) {
                for (iy in -3..3) {
                    for (axis in 0..1) {
                        assertEquals(
                            known.shift(Images.code(ix, iy, 0), axis),
                            images.shift(ix, iy, axis),
                            1e-12,
                        ) {
                            "$boundary $ix $iy"
                        }
                    }
                }
            }
        }
    }

    @Test
    fun `rows are those of the shear, and open faces have no images`() {
        assertEquals(1, PlaneImages(LeesEdwards(box, 0.7), 0.0).across)
        assertEquals(0, PlaneImages(HillSheet(box, 1.0), 0.0).across)
        assertFalse(PlaneImages(HillSheet(box, 1.0, true), 0.0).repeats(0))
        assertTrue(PlaneImages(HillSheet(box, 1.0, true), 0.0).repeats(1))
        assertFalse(PlaneImages(Open, 0.0).repeats(1))
    }
}
