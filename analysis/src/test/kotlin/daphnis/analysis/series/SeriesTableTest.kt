package daphnis.analysis.series

import daphnis.core.format.FormatException
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class SeriesTableTest {
    @TempDir
    lateinit var home: Path

    private fun read(text: String) = SeriesTable.read(Files.writeString(home.resolve("series.csv"), text))

    private fun assertDamaged(text: String, vararg parts: String) {
        val message = assertThrows(FormatException::class.java) { read(text) }.message!!
        for (part in parts.asList() + "series.csv") assertTrue(part in message) { message }
        assertFalse('\n' in message)
    }

    @Test
    fun `columns are known by name, in any order and beside others, with an empty cell as NaN`() {
        val table = read("new,collisions,time,particles\n7,0,0.5,3\n,4,1.5,3\n")
        assertEquals(2, table.size)
        assertArrayEquals(doubleArrayOf(0.5, 1.5), table["time"])
        assertArrayEquals(doubleArrayOf(0.0, 4.0), table["collisions"])
        assertArrayEquals(doubleArrayOf(7.0, Double.NaN), table["new"])
        assertEquals(setOf("new", "collisions", "time", "particles"), table.names)
        assertTrue("new" in table && "old" !in table)
    }

    @Test
    fun `what a run has not finished writing is left out, though half a number looks like a whole one`() {
        val head = "step,time [s],particles,collisions\n"
        assertEquals(1, read("${head}0,0,10,0\n1,12").size)
        // 125 collisions, of which the 5 is not on the disk yet.
        assertArrayEquals(doubleArrayOf(0.0), read("${head}0,0,10,0\n1,1,10,12")["collisions"])
        assertEquals(1, read("${head}0,0,10,0\n1,1\n").size)
        assertEquals(0, read(head).size)
        assertEquals(0, read("step,tim").size)
        assertEquals(0, read("").size)
    }

    @Test
    fun `damage is one line that names file and line`() {
        val head = "step,time,particles,collisions\n"
        assertDamaged("step,time,particles\n0,0,10\n", "'collisions'", "missing")
        assertDamaged("${head}0,0,10,0\n1,1,10\n2,2,10,9\n", ":3: 3 values", "4")
        assertDamaged("${head}0,0,10,0\n1,1,10,9,9\n", ":3: 5 values")
        assertDamaged("${head}0,0,ten,0\n", ":2: particles is 'ten'", "number")
        assertDamaged("${head}0,0,,0\n", ":2: particles is ''", "number")
        assertDamaged("${head}0,NaN,10,0\n", ":2: time", "finite")
        assertDamaged("${head}0,1,10,0\n1,0.5,10,0\n", ":3: time is '0.5'", "1.0")
        Files.write(home.resolve("series.csv"), byteArrayOf(0x73, 0xff.toByte(), 0xfe.toByte(), 0x0a))
        assertTrue(
            "cannot be read" in
                assertThrows(FormatException::class.java) { SeriesTable.read(home.resolve("series.csv")) }.message!!,
        )
    }
}
