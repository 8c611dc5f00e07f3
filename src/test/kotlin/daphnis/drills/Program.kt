package daphnis.drills

import java.io.File
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit

/** How a program ended: its exit code, null when it had to be killed because it went on too long; and all it said. */
internal class Ended(val code: Int?, val text: String, val seconds: Double) {
    /** A stack trace where a line should stand. */
    val hasTrace: Boolean get() = text.lines().any { it.startsWith("\tat ") || it.startsWith("Exception in thread") }
}

/**
 * daphnis as a process of its own, on the class path and the Java of this one.
 *
 * @param before words of a command that starts it in its own place, such as another network
 */
internal class Program(
    private val directory: Path,
    heap: String,
    private val arguments: List<String>,
    before: List<String> = emptyList(),
) {
    private val log = Files.createTempFile(directory, "says", ".txt")
    private val begin = System.nanoTime()
    private val process: Process

    init {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val command = before +
            listOf(java, "-Xmx$heap", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-Ddaphnis.workDone=$MUCH") +
            "daphnis.app.MainKt" + arguments
        val builder = ProcessBuilder(
            command,
        ).directory(directory.toFile()).redirectErrorStream(true).redirectOutput(log.toFile())
        val classes = ManagementFactory.getRuntimeMXBean().classPath.split(File.pathSeparator)
        builder.environment()["CLASSPATH"] =
            classes.joinToString(File.pathSeparator) { Path.of(it).toAbsolutePath().toString() }
        process = builder.start()
        living += process
    }

    val pid: Long get() = process.pid()
    val isAlive: Boolean get() = process.isAlive

    /** All that it has said up to now. */
    val said: String get() = if (Files.exists(log)) Files.readString(log) else ""
    val seconds: Double get() = (System.nanoTime() - begin) * 1e-9

    /** `kill -9`. */
    fun kill() {
        process.destroyForcibly().waitFor()
    }

    /** `kill -TERM`. */
    fun terminate() {
        process.destroy()
    }

    /** Sends the signal with this name, such as STOP. */
    fun signal(name: String) {
        if (isAlive) ProcessBuilder("kill", "-$name", "$pid").start().waitFor()
    }

    /** Waits for the end, at most [limit] seconds from now. */
    fun await(limit: Double = LONG): Ended {
        val code = if (process.waitFor((limit * 1000).toLong(), TimeUnit.MILLISECONDS)) process.exitValue() else null
        if (code == null) kill()
        living -= process
        val text = said
        Files.deleteIfExists(log)
        return Ended(code, text, seconds)
    }

    companion object {
        /** No run is short after so much work: epochs are drilled, too. */
        private const val MUCH = 1_000_000_000L

        /** None stays behind when a drill is ended by a signal. */
        private val living: MutableSet<Process> = ConcurrentHashMap.newKeySet()

        init {
            Runtime.getRuntime().addShutdownHook(Thread { for (process in living) process.destroyForcibly() })
        }

        /** Seconds after which a program hangs, whatever the machine. */
        const val LONG = 300.0

        /** Runs what has to come out well for anything else to be tried. */
        fun succeed(directory: Path, vararg arguments: String) {
            val ended = run(directory, *arguments)
            check(ended.code == 0) { "${arguments.joinToString(" ")} ended with ${ended.code}: ${ended.text}" }
        }

        fun run(directory: Path, vararg arguments: String, heap: String = "512m"): Ended =
            Program(directory, heap, arguments.toList()).await()
    }
}

/** What `--threads` is for [engine]. */
internal fun threadsOf(engine: String): String = if (engine == "serial") "1" else "2"
