package daphnis.analysis.transport

import daphnis.analysis.series.SeriesTable
import daphnis.core.format.FormatException
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class ImpactTableTest {
    @TempDir
    lateinit var directory: Path

    private fun file(vararg rows: String): Path =
        Files.write(directory.resolve("impacts.csv"), listOf("speed_from,speed_to,collisions") + rows)

    @Test
    fun `bins come back in their order, and a file may have none`() {
        val table = ImpactTable.read(file("0.5,1.0,7", "1.0,2.0,0", "2.0,4.0,3"))
        assertEquals(3, table.size)
        assertArrayEquals(doubleArrayOf(0.5, 1.0, 2.0), table.from)
        assertArrayEquals(doubleArrayOf(1.0, 2.0, 4.0), table.to)
        assertArrayEquals(doubleArrayOf(7.0, 0.0, 3.0), table.collisions)
        assertEquals(0, ImpactTable.read(file()).size)
    }

    @Test
    fun `a row that is no bin is named with its line`() {
        val bad =
            listOf("0,1,7", "-1,1,7", "1,1,7", "2,1,7", "0.5,1,-1", "0.5,1", "0.5,1,7,8", "0.5,one,7", "0.5,NaN,7")
        for (row in bad + listOf("0.5,Infinity,7", "", "0.5,1,Infinity")) {
            val e =
                assertThrows(FormatException::class.java, { ImpactTable.read(file("0.25,0.5,1", row, "2,4,1")) }, row)
            assertTrue(e.message!!.contains("impacts.csv:3: is '$row'")) { e.message }
        }
        val missing = directory.resolve("nowhere.csv")
        val e = assertThrows(FormatException::class.java) { ImpactTable.read(missing) }
        assertTrue(e.message!!.startsWith("$missing: cannot be read")) { e.message }
    }

    @Test
    fun `bytes that are no text are named as such`() {
        val bytes = Files.write(directory.resolve("bytes.csv"), byteArrayOf(0xC3.toByte(), 0x28, 10))
        for (read in listOf(ImpactTable::read, SeriesTable::read)) {
            val e = assertThrows(FormatException::class.java) { read(bytes) }
            assertEquals("$bytes: cannot be read: is not UTF-8 text", e.message)
        }
    }
}
