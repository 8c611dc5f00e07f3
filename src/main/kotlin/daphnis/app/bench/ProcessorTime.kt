package daphnis.app.bench

import com.sun.management.OperatingSystemMXBean
import java.lang.management.ManagementFactory

/** The time that all processors together have given this JVM, to a hundredth of a second. */
internal object ProcessorTime {
    private val bean = ManagementFactory.getOperatingSystemMXBean() as? OperatingSystemMXBean

    /** Seconds since the JVM began; NaN where the system does not say. */
    fun seconds(): Double = bean?.processCpuTime?.takeIf { it >= 0 }?.let { it * NANO } ?: Double.NaN

    private const val NANO = 1e-9
}
