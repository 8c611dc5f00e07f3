package daphnis.app.bench

import com.sun.management.OperatingSystemMXBean
import java.lang.management.ManagementFactory

/** The time that all processors together have given this JVM, to a hundredth of a second. */
internal object ProcessorTime {
    private val bean = ManagementFactory.getOperatingSystemMXBean() as? OperatingSystemMXBean

    /** Nanoseconds since the JVM began; null where the system does not say. */
    fun now(): Long? = bean?.processCpuTime?.takeIf { it >= 0 }

    /** Seconds since it was [begin]; NaN where the system does not say. */
    fun secondsSince(begin: Long?): Double {
        val end = now()
        return if (begin == null || end == null) Double.NaN else (end - begin) / NANOS
    }

    private const val NANOS = 1e9
}
