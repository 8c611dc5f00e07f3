package daphnis.core

import java.io.IOException
import java.net.ServerSocket
import java.util.concurrent.atomic.AtomicInteger

/**
 * Ports of this machine that stay free until somebody listens there: none of those that the system gives to whoever
 * connects or asks for any (from 32768 on under Linux, from 49152 on elsewhere), and others in each process of tests.
 */
object FreePorts {
    private const val FIRST = 20_000
    private const val COUNT = 10_000
    private val next = AtomicInteger((ProcessHandle.current().pid() * 127 % COUNT).toInt())

    /** A port where nobody listens, another at each call. */
    fun one(): Int {
        repeat(COUNT) {
            val port = FIRST + Math.floorMod(next.getAndIncrement(), COUNT)
            try {
                ServerSocket(port).close()
                return port
            } catch (_: IOException) {
                // Somebody listens there.
            }
        }
        error("no free port in $FIRST..${FIRST + COUNT - 1}")
    }
}
