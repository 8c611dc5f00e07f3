package daphnis.core.run

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.io.IOException
import java.util.Collections
import java.util.concurrent.CountDownLatch
import kotlin.concurrent.thread

@Timeout(60)
class WriterThreadTest {
    private val plenty = { Long.MAX_VALUE }
    private val log: MutableList<String> = Collections.synchronizedList(ArrayList())

    /** A writer whose first piece is under way until [gate] opens. */
    private inner class Blocked(mostRows: Long = 100, memory: () -> Long = plenty) {
        val gate = CountDownLatch(1)
        private val begun = CountDownLatch(1)
        val writer = WriterThread(mostRows, memory)

        init {
            writer.rows(0) {
                begun.countDown()
                gate.await()
            }
            begun.await()
        }
    }

    /** Whether [act], on another thread, comes to wait until [open] is called. */
    private fun waits(act: () -> Unit, open: () -> Unit): Boolean {
        val caller = thread { act() }
        while (caller.isAlive && caller.state != Thread.State.WAITING) Thread.onSpinWait()
        val waited = caller.isAlive
        open()
        caller.join()
        return waited
    }

    @Test
    fun `pieces are written one after the other in their order, on one other thread`() {
        val threads = HashSet<Thread>()
        WriterThread(100, plenty).use { writer ->
            for (k in 0 until 1000) {
                if (k % 10 == 0) {
                    writer.state(8, { k }) { log += "state $it" }
                } else {
                    writer.rows(7) { log += "rows $k".also { threads += Thread.currentThread() } }
                }
            }
            writer.await()
            assertEquals(List(1000) { if (it % 10 == 0) "state $it" else "rows $it" }, log)
        }
        assertEquals("daphnis-writer", threads.single().name)
        assertTrue(threads.single().isDaemon)
        threads.single().join()
    }

    @Test
    fun `the caller goes on while one state is written and one waits, and waits with the next before it is copied`() {
        val blocked = Blocked()
        blocked.writer.state(8, { log += "copy 1" }) { log += "write 1" }
        assertEquals(listOf("copy 1"), log.toList())
        val waited = waits({ blocked.writer.state(8, { log += "copy 2" }) { log += "write 2" } }) {
            assertEquals(listOf("copy 1"), log.toList())
            blocked.gate.countDown()
        }
        assertTrue(waited)
        blocked.writer.close()
        assertEquals(setOf("copy 1", "write 1", "copy 2", "write 2"), log.toSet())
        assertTrue(log.indexOf("write 1") < log.indexOf("write 2"))
    }

    @Test
    fun `rows wait up to their bound, or one piece of any size, and no state counts among them`() {
        val blocked = Blocked(mostRows = 100)
        blocked.writer.state(1000, { }) { }
        blocked.writer.rows(1000) { log += "large" }
        assertTrue(waits({ blocked.writer.rows(1) { log += "small" } }) { blocked.gate.countDown() })
        val second = Blocked(mostRows = 100)
        repeat(10) { second.writer.rows(10) { } }
        assertTrue(waits({ second.writer.rows(10) { } }) { second.gate.countDown() })
        blocked.writer.close()
        second.writer.close()
        assertEquals(listOf("large", "small"), log.toList())
    }

    @Test
    fun `the first failure is thrown once, and nothing is written after it`() {
        val first = IOException("first")
        val blocked = Blocked()
        blocked.writer.check()
        blocked.writer.rows(1) { throw first }
        blocked.writer.rows(1) { log += "later" }
        blocked.writer.state(1, { log += "copied before the failure" }) { throw IOException("second") }
        blocked.gate.countDown()
        assertSame(first, assertThrows(IOException::class.java) { blocked.writer.await() })
        blocked.writer.state(1, { log += "copied" }) { log += "later" }
        blocked.writer.rows(1) { log += "later" }
        blocked.writer.check()
        blocked.writer.close()
        assertEquals(listOf("copied before the failure"), log.toList())
    }

    @Test
    fun `a failure that has not been thrown is thrown on closing, an Error too`() {
        val error = OutOfMemoryError("on purpose")
        val writer = WriterThread(100, plenty)
        writer.rows(1) { throw error }
        assertSame(error, assertThrows(OutOfMemoryError::class.java) { writer.close() })
    }

    @Test
    fun `where the system gives no thread, everything is written at once`() {
        val writer = WriterThread(100, plenty) { throw OutOfMemoryError("unable to create native thread") }
        val here = Thread.currentThread()
        writer.rows(1000) { log += "rows".also { assertSame(here, Thread.currentThread()) } }
        writer.state(1000, { "state" }) { log += it }
        assertEquals(listOf("rows", "state"), log.toList())
        writer.rows(1) { throw IOException("full") }
        assertThrows(IOException::class.java) { writer.check() }
        writer.close()
    }

    @Test
    fun `where memory is short, a state is written before the run goes on`() {
        val blocked = Blocked(memory = { 399 })
        assertTrue(waits({ blocked.writer.state(100, { }) { log += "written" } }) { blocked.gate.countDown() })
        assertEquals(listOf("written"), log.toList())
        blocked.writer.close()
        val enough = Blocked(memory = { 400 })
        enough.writer.state(100, { }) { }
        enough.gate.countDown()
        enough.writer.close()
    }

    @Test
    fun `where there is no memory for a copy, it is taken once more when all is written`() {
        val blocked = Blocked()
        var tries = 0
        val copy = { if (tries++ == 0) throw OutOfMemoryError("on purpose") else tries }
        assertTrue(waits({ blocked.writer.state(1, copy) { log += "try $it" } }) { blocked.gate.countDown() })
        blocked.writer.close()
        assertEquals(listOf("try 2"), log.toList())
        WriterThread(100, plenty).use { writer ->
            val never = { throw OutOfMemoryError("on purpose") }
            assertThrows(OutOfMemoryError::class.java) { writer.state<Int>(1, never) { } }
        }
    }

    @Test
    fun `an interrupt does not end a wait, and is still set after it`() {
        val blocked = Blocked()
        val waiting = CountDownLatch(1)
        var flag = false
        val caller = thread {
            waiting.countDown()
            blocked.writer.await()
            flag = Thread.currentThread().isInterrupted
        }
        waiting.await()
        caller.interrupt()
        caller.join(100)
        assertTrue(caller.isAlive)
        blocked.gate.countDown()
        caller.join()
        assertTrue(flag)
        blocked.writer.close()
    }
}
