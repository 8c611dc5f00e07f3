package daphnis.analysis.report

import daphnis.core.run.RunLock
import java.nio.file.Path

/** Another process that locks a directory until it is killed. */
object LockHolder {
    /** The process, once it has the lock of [directory]. */
    fun start(directory: Path): Process {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val classes = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
        val process = ProcessBuilder(java, "-cp", classes, LockHolder::class.java.name, directory.toString())
            .redirectError(ProcessBuilder.Redirect.INHERIT).start()
        check(process.inputReader().readLine() == "locked")
        return process
    }

    @JvmStatic
    fun main(args: Array<String>) {
        RunLock.take(Path.of(args[0]))
        println("locked")
        Thread.sleep(Long.MAX_VALUE)
    }
}
