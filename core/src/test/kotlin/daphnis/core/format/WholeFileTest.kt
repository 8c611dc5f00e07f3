package daphnis.core.format

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries

class WholeFileTest {
    @TempDir
    lateinit var home: Path

    @Test
    fun `a full disk is a full disk, also where a library wraps it`() {
        val file = Files.writeString(home.resolve("a"), "before")
        val full = IOException("No space left on device")
        for (thrown in listOf(full, IllegalStateException("writing at 7", full), IllegalArgumentException("other"))) {
            val e = assertThrows(Exception::class.java) {
                wholeFile(file) {
                    Files.writeString(it, "half")
                    throw thrown
                }
            }
            assertSame(if (thrown is IllegalArgumentException) thrown else full, e)
            assertEquals(listOf(file), home.listDirectoryEntries())
            assertEquals("before", Files.readString(file))
        }
        assertEquals(7, wholeFile(file) { Files.writeString(it, "after").let { 7 } })
        assertEquals("after", Files.readString(file))
    }

    @Test
    fun `text and bytes replace a file by another, so that who reads the old one reads it to its end`() {
        val file = Files.writeString(home.resolve("a"), "before")
        val held = Files.createLink(home.resolve("held"), file)
        WholeFile.write(file, "text φ")
        assertEquals("text φ", Files.readString(file))
        WholeFile.write(file, byteArrayOf(7))
        assertEquals(listOf<Byte>(7), Files.readAllBytes(file).asList())
        WholeFile.write(file) { Files.writeString(it, "after") }
        assertEquals("after", Files.readString(file))
        assertEquals("before", Files.readString(held))
        assertEquals(setOf(file, held), home.listDirectoryEntries().toSet())
    }

    @Test
    fun `a link is replaced and its target stays, and what is no file is not replaced`() {
        val file = Files.writeString(home.resolve("a"), "before")
        val link = Files.createSymbolicLink(home.resolve("link"), file)
        wholeFile(link) { Files.writeString(it, "after") }
        assertFalse(Files.isSymbolicLink(link))
        assertEquals("after", Files.readString(link))
        assertEquals("before", Files.readString(file))
        val folder = Files.createDirectory(home.resolve("folder"))
        assertEquals(folder, wholeFile(folder) { it })
    }

    @Test
    fun `nor is what bears the name under which it is written first`() {
        val precious = Files.writeString(home.resolve("precious"), "precious")
        val part = home.resolve("new.part")
        for (isHard in listOf(false, true)) {
            if (isHard) Files.createLink(part, precious) else Files.createSymbolicLink(part, precious)
            WholeFile.write(home.resolve("new"), "new")
            assertEquals("new", Files.readString(home.resolve("new")))
            assertEquals("precious", Files.readString(precious))
            assertTrue(Files.notExists(part, NOFOLLOW_LINKS))
        }
    }
}
