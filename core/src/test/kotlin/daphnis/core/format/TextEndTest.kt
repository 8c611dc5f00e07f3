package daphnis.core.format

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class TextEndTest {
    @TempDir
    lateinit var home: Path

    private val files = mapOf(
        "a.csv" to "x,y,z,radius\n0,0,0,0.5\n3.25,0,0,0.125\n",
        "a.xyz" to "2\nProperties=species:S:1:pos:R:3:radius:R:1\nX 0 0 0 0.5\nX 3.25 0 0 0.125\n",
        "a.lammpstrj" to "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n" +
            "ITEM: ATOMS id x y z radius\n1 1 1 1 0.5\n2 5 5 5 0.125\n",
        "a.data" to "title\n\n2 atoms\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms # sphere\n\n" +
            "1 1 1 2 1 1 1\n2 1 0.25 2 5 5 5.125\n",
    )

    private fun file(name: String, text: String) = Files.writeString(home.resolve(name), text)

    @Test
    fun `a text that is cut anywhere within its last line is refused, or it is said that it may be`() {
        for ((name, whole) in files) {
            val file = file(name, whole)
            val right = SnapshotFormats.read(file).last()
            assertNull(SnapshotFormats.remark(file)) { name }
            val lastLine = whole.trimEnd().lastIndexOf('\n') + 1
            var said = 0
            for (length in lastLine + 1 until whole.length) {
                file(name, whole.take(length))
                val read = try {
                    SnapshotFormats.read(file).last()
                } catch (e: FormatException) {
                    continue
                }
                val remark = SnapshotFormats.remark(file)
                assertNotNull(remark) { "$name: ${whole.take(length)}" }
                assertTrue(remark!!.startsWith("$file: the last line has no end")) { remark }
                said++
                assertEquals(right.size, read.size)
            }
            assertTrue(said in 3..6) { "$name: $said" }
        }
    }

    @Test
    fun `a last line without a number, an end of another system, and a file of no text have no remark`() {
        val csv = files.getValue("a.csv")
        for (end in listOf("# made by hand", "   ", "")) assertNull(SnapshotFormats.remark(file("a.csv", csv + end)))
        assertNull(SnapshotFormats.remark(file("a.csv", csv.replace("\n", "\r\n"))))
        assertNull(SnapshotFormats.remark(file("a.csv", csv.replace("\n", "\r"))))
        assertNotNull(SnapshotFormats.remark(file("a.csv", csv.replace("\n", "\r\n").dropLast(2))))
        assertNull(SnapshotFormats.remark(file("a.bin", csv.trimEnd())))
        assertNull(SnapshotFormats.remark(file("empty.csv", "")))
        assertNotNull(SnapshotFormats.remark(file("long.csv", "1".repeat(100_000))))
    }
}
