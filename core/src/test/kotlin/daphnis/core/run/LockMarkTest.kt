package daphnis.core.run

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class LockMarkTest {
    @TempDir
    lateinit var home: Path

    private val file get() = home.resolve(LockMark.FILE)

    private fun busy(): LockMark.Busy = assertThrows(LockMark.Busy::class.java) { LockMark.make(home) }

    @Test
    fun `a mark keeps others out until it is closed`() {
        LockMark.make(home).use {
            val words = Files.readString(file).trim().split(' ')
            assertEquals(3, words.size)
            assertEquals(ProcessHandle.current().pid().toString(), words[1])
            assertTrue(busy().isKnown)
            assertTrue(Files.exists(file))
        }
        assertFalse(Files.exists(file))
        LockMark.make(home).close()
    }

    @Test
    fun `a mark of a process that has ended is taken away, and of one whose number is used again`() {
        val mine = LockMark.make(home).use { Files.readString(file).trim().split(' ') }
        for (dead in listOf("${mine[0]} ${Int.MAX_VALUE} 5", "${mine[0]} ${mine[1]} 5")) {
            Files.writeString(file, dead)
            LockMark.make(home).use {
                assertTrue(Files.readString(file).startsWith("${mine[0]} ${mine[1]} ${mine[2]}"))
            }
            assertEquals(0, Files.list(home).use { it.count() })
        }
    }

    @Test
    fun `a mark of another machine, an empty one and a guard stay, and are named`() {
        for (other in listOf("elsewhere 5 7", "", "one two", "a\u001b[31m b c d")) {
            Files.writeString(file, other)
            val e = busy()
            assertFalse(e.isKnown)
            assertEquals(file, e.file)
            assertTrue(e.who.all { it in ' '..'~' })
            assertEquals(other, Files.readString(file))
        }
        val mine = Files.delete(file).let { LockMark.make(home).use { Files.readString(file).trim().split(' ') } }
        Files.writeString(file, "${mine[0]} ${Int.MAX_VALUE} 5")
        Files.createDirectory(home.resolve(LockMark.GUARD))
        assertEquals(home.resolve(LockMark.GUARD), busy().file)
    }
}
