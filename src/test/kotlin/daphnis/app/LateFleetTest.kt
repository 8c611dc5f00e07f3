package daphnis.app

import daphnis.core.cluster.BusyNode
import daphnis.core.cluster.Fleet
import daphnis.core.cluster.FleetException
import daphnis.core.cluster.FleetNode
import daphnis.core.cluster.Mail
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.lang.reflect.Proxy
import java.util.concurrent.CountDownLatch
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/** A fleet that is waited for can be given up; one that is there goes on. */
class LateFleetTest {
    private object Nobody : Fleet {
        override fun nodes(): List<FleetNode> = emptyList()

        override fun busy(): List<BusyNode> = emptyList()

        override fun form(nodes: List<FleetNode>): Mail = throw UnsupportedOperationException()

        override fun close() = Unit
    }

    @Test
    fun `a start that waits ends, and the thread is as it was`() {
        val waits = CountDownLatch(1)
        val fleet = LateFleet { Nobody.also { waits.countDown().also { Thread.sleep(60_000) } } }
        val pool = Executors.newSingleThreadExecutor()
        try {
            val asked = pool.submit { fleet.nodes() }
            waits.await()
            fleet.giveUp()
            val e = assertThrows(ExecutionException::class.java) { asked.get(10, TimeUnit.SECONDS) }
            assertTrue(e.cause is FleetException) { "${e.cause}" }
            assertEquals(false, pool.submit<Boolean> { Thread.currentThread().isInterrupted }.get())
        } finally {
            pool.shutdownNow()
        }
        assertThrows(FleetException::class.java) { fleet.nodes() }
    }

    @Test
    fun `nodes can compute from when they work together until they are waited for again`() {
        val fleet = LateFleet {
            object : Fleet by Nobody {
                override fun form(nodes: List<FleetNode>): Mail =
                    Proxy.newProxyInstance(javaClass.classLoader, arrayOf(Mail::class.java)) { _, _, _ -> null } as Mail
            }
        }
        fleet.nodes()
        assertEquals(0, fleet.able)
        fleet.form(emptyList())
        Thread.sleep(1)
        assertTrue(fleet.able > 0)
        fleet.busy()
        assertEquals(0, fleet.able)
    }

    @Test
    fun `who has nodes goes on, and who waits for more does not`() {
        val fleet = LateFleet { Nobody }
        assertEquals(0, fleet.nodes().size + fleet.busy().size)
        fleet.giveUp()
        assertEquals(0, fleet.nodes().size)
        assertThrows(FleetException::class.java) { fleet.busy() }
    }
}
