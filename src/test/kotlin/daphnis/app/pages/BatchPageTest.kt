package daphnis.app.pages

import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import java.util.concurrent.TimeUnit

/** The batch script in the documentation does what the page says, with an array that a few lines of shell imitate. */
@Tag("jdk-neutral")
class BatchPageTest {
    @TempDir
    lateinit var folder: Path

    private fun program(name: String, text: String) {
        Files.writeString(folder.resolve(name), "#!/bin/sh\n$text\n")
        Files.setPosixFilePermissions(folder.resolve(name), PosixFilePermissions.fromString("rwxr-xr-x"))
    }

    /** A task of an array of three; the exit code of the script. */
    private fun task(number: Int): Int {
        val builder = ProcessBuilder("sh", "sweep.sh").directory(folder.toFile())
            .redirectErrorStream(true).redirectOutput(folder.resolve("log-$number").toFile())
        builder.environment().putAll(
            mapOf(
                "PATH" to "$folder:${System.getenv("PATH")}",
                "SLURM_ARRAY_JOB_ID" to "7",
                "SLURM_ARRAY_TASK_ID" to "$number",
                "SLURM_ARRAY_TASK_COUNT" to "3",
                "SLURM_ARRAY_TASK_MIN" to "1",
                "SLURM_ARRAY_TASK_MAX" to "3",
                "SLURM_CPUS_PER_TASK" to "1",
            ),
        )
        val task = builder.start()
        assertTrue(task.waitFor(120, TimeUnit.SECONDS))
        return task.exitValue()
    }

    private fun log(number: Int) = Files.readString(folder.resolve("log-$number"))

    @Test
    fun `an array carries out a sweep, and a task at its time limit is put into the queue again and goes on`() {
        val page = Files.readString(Repository.root.resolve("docs/batch.md"))
        val script = Regex(
            """<!-- sbatch -->\n```sh\n(.*?)```""",
            RegexOption.DOT_MATCHES_ALL,
        ).find(page)!!.groupValues[1]
        val short = "cooling-gas --set particles.count=60 --set until=60 --set restitution.coefficient=0.5,0.9 " +
            "--seeds 1..3 --quiet"
        val words = Regex("""ring-patch .*?--seeds 1\.\.8""")
        assertTrue(words.containsMatchIn(script))
        Files.writeString(folder.resolve("sweep.sh"), script.replace(words, Regex.escapeReplacement(short)))
        val java = Path.of(System.getProperty("java.home"), "bin", "java")
        val classes = System.getProperty("java.class.path").split(File.pathSeparator)
            .joinToString(File.pathSeparator) { Path.of(it).toAbsolutePath().toString() }
        Files.writeString(folder.resolve("arguments"), "-cp\n\"$classes\"\ndaphnis.app.MainKt\n")
        program("daphnis", "exec '$java' @'$folder/arguments' \"\$@\"")
        program("scontrol", "echo \"\$@\" >> '$folder/requeued'")
        // At its time limit a task gets a signal; here soon after its first run has begun.
        program(
            "srun",
            "\"\$@\" & p=\$!\n" +
                "if [ ! -e limit-\$SLURM_ARRAY_TASK_ID ] && [ \$SLURM_ARRAY_TASK_ID = 2 ]; then\n" +
                "  touch limit-\$SLURM_ARRAY_TASK_ID\n" +
                "  until ls runs/depths/runs/*seed=2/scenario.json > /dev/null 2>&1\n" +
                "  do kill -0 \$p || exit 9; sleep .1; done\n" +
                "  kill -TERM \$p\nfi\nwait \$p",
        )
        assertEquals(listOf(0, 130, 0), (1..3).map { task(it) }) { (1..3).joinToString("\n") { log(it) } }
        assertEquals("requeue 7_2", Files.readString(folder.resolve("requeued")).trim())
        assertTrue("interrupted with " in log(2)) { log(2) }
        assertFalse(Files.exists(folder.resolve("runs/depths/sweep.csv")))
        assertEquals(0, task(2)) { log(2) }
        val runs = folder.resolve("runs/depths/runs").toFile().listFiles()!!
        assertEquals(6, runs.count { "\"finished\": true" in it.resolve("summary.json").readText() })
    }
}
