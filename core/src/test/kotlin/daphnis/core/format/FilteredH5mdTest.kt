package daphnis.core.format

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Path
import kotlin.math.floor
import kotlin.math.sqrt

/** Files that h5py 3.16 wrote, with HDF5 2.0. */
class FilteredH5mdTest {
    private fun file(name: String) = Path.of(javaClass.getResource("/daphnis/hdf5/$name")!!.toURI())

    /** As it was made: spread over the box by parts of roots; some alike, so that there is something to compress. */
    private fun place(t: Int, k: Int, axis: Int): Double {
        if (axis == 2 && k >= 25) return 0.25 * t
        val root = sqrt((k * 3.0 + axis) * 3 + t + 2) * 1000
        return ((root - floor(root)) * 8 - 4) / 3
    }

    @Test
    fun `chunks that went without some of their filters are read as they are`() {
        // LZF and Fletcher-32 in chunks of 2 × 20 × 2; shuffle and gzip with chunks that went without them,
        // also big-endian.
        val states = H5md.read(file("masked.h5"))
        assertEquals(3, states.size)
        for ((t, state) in states.withIndex()) {
            for (k in 0 until 50) {
                for (axis in 0..2) assertEquals(place(t, k, axis), state.position[axis][k], "$t $k $axis")
                assertEquals((0.1 * (t + 1)).toFloat().toDouble(), state.radius[k], "$t $k")
                assertEquals(k + 1.0, state.mass[k])
            }
        }
    }

    @Test
    fun `a layout of HDF5 2 is named, with the way out`() {
        val told = assertThrows(FormatException::class.java) { H5md.read(file("layout5.h5")) }.message!!
        assertTrue("version = 5" in told && "HDF5 1.14 or older" in told && "not an H5MD" !in told) { told }
    }
}
