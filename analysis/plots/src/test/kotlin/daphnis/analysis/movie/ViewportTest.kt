package daphnis.analysis.movie

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ViewportTest {
    private fun view(across: Double, up: Double) = Viewport(Window(-across / 2, across / 2, 0.0, up), 1200)

    @Test
    fun `a box that is not flat is to scale and fills the width`() {
        val view = view(100.0, 50.0)
        assertEquals(listOf(1, 1, 600, 0, 1200), of(view))
        assertEquals(12.0, view.scaleX)
        assertEquals(12.0, view.scaleY)
        assertEquals(0.0, view.x(-50.0))
        assertEquals(600.0, view.y(0.0))
    }

    @Test
    fun `a flat box has its vertical enlarged by the least round factor that makes it stout`() {
        assertEquals(listOf(1, 1, 150, 0, 1200), of(view(80.0, 10.0)))
        assertEquals(listOf(2, 1, 299, 0, 1200), of(view(80.5, 10.0)))
        assertEquals(listOf(2, 1, 150, 0, 1200), of(view(160.0, 10.0)))
        assertEquals(listOf(5, 1, 373, 0, 1200), of(view(161.2, 10.0)))
        assertEquals(listOf(10, 1, 150, 0, 1200), of(view(800.0, 10.0)))
        assertEquals(listOf(200, 1, 191, 0, 1200), of(view(12600.0, 10.0)))
    }

    @Test
    fun `a high box stands in the middle, and a very narrow one has its horizontal enlarged`() {
        assertEquals(listOf(1, 1, 1200, 450, 750), of(view(25.0, 100.0)))
        val narrow = view(1.0, 100.0)
        assertEquals(20, narrow.enlargedAcross)
        assertEquals(12.0, narrow.scaleY)
        assertEquals(240.0, narrow.scaleX)
        assertEquals(240, narrow.endColumn - narrow.firstColumn)
    }

    private fun of(view: Viewport) =
        listOf(view.enlargedUp, view.enlargedAcross, view.height, view.firstColumn, view.endColumn)
}
