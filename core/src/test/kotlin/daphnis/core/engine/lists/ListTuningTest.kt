package daphnis.core.engine.lists

import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.engine.horizon.HorizonTuning
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ListTuningTest {
    /** The most spheres that lists are used for at each filling factor, on so many threads; 0 for none. */
    private fun most(threads: Int, vararg fillings: Double): List<Int> = fillings.map { filling ->
        (1..30_000).lastOrNull { ListTuning.best(threads).suits(it, filling) } ?: 0
    }

    @Test
    fun `more spheres the denser they are and the fewer threads would share the work in another way`() {
        assertEquals(listOf(0, 12_000, 12_000, 24_000, 24_000), most(1, 0.37, 0.38, 0.44, 0.45, 0.6))
        assertEquals(listOf(0, 10_000, 16_000), most(2, 0.37, 0.38, 0.45))
        assertEquals(listOf(0, 6000, 6000), most(3, 0.37, 0.38, 0.45))
        assertEquals(most(3, 0.4), most(64, 0.4))
    }

    @Test
    fun `very few spheres are left to others`() {
        for (threads in 1..3) {
            assertEquals(100, (1..1000).first { ListTuning.best(threads).suits(it, 0.5) })
        }
    }

    @Test
    fun `who asks for epochs gets no lists`() {
        fun most(fewest: Int, tuning: HorizonTuning?) =
            (1..30_000).lastOrNull { HorizonSteps.listsFor(1, fewest, tuning).suits(it, 0.5) }
        assertEquals(24_000, most(1, null))
        assertEquals(null, most(0, null))
        assertEquals(null, most(1, HorizonTuning(2)))
    }
}
