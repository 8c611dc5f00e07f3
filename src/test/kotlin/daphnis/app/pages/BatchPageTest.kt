package daphnis.app.pages

import daphnis.app.EXIT_INPUT
import daphnis.app.EXIT_INTERRUPTED
import daphnis.app.sweep.SweepPart
import daphnis.core.Repository
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import java.util.concurrent.TimeUnit

/**
 * The batch script in the documentation does what the page says, with an array that a few lines of shell imitate, and
 * the manifests for Kubernetes have command lines and variables that the program takes.
 */
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

    private fun manifest(name: String) = Files.readString(Repository.root.resolve("docs/batch/$name"))

    /** Words of the container's command line, whose lists are written as JSON. */
    private fun words(manifest: String): List<String> = listOf("command", "args").flatMap { key ->
        val list = Regex("""(?m)^ *$key: (\[[^]]*])""").find(manifest)!!.groupValues[1]
        Json.parseToJsonElement(list).jsonArray.map { it.jsonPrimitive.content }
    }

    private fun List<String>.after(option: String) = this[indexOf(option) + 1]

    @Test
    fun `a job of Kubernetes has a pod for each part, and goes on with what was interrupted alone`() {
        val job = manifest("kubernetes-job.yaml")
        val words = words(job)
        assertNull(CommandCheck().problem(words))
        val completions = Regex("""(?m)^  completions: (\d+)$""").find(job)!!.groupValues[1].toInt()
        val variables = Regex("""- name: ([A-Z_]+)\n +value: "(.*)"""").findAll(job)
            .associate { it.groupValues[1] to it.groupValues[2] }
        val parts = (0 until completions).map { k ->
            "${SweepPart.parse(words.after("--part"), variables + ("JOB_COMPLETION_INDEX" to "$k"))}"
        }
        assertEquals((1..completions).map { "part $it of $completions" }, parts)
        // 143 is what Java ends with that is not yet the program's.
        val codes = Regex("""action: (\w+)\s+onExitCodes:\s+operator: In\s+values: \[(.*)]""").findAll(job)
            .associate { it.groupValues[1] to it.groupValues[2] }
        assertEquals(mapOf("Ignore" to "$EXIT_INTERRUPTED, 143", "FailJob" to "$EXIT_INPUT"), codes)
    }

    @Test
    fun `a job of Kubernetes makes the tables of the runs of the other one`() {
        val job = manifest("kubernetes-job.yaml")
        val tables = manifest("kubernetes-collect.yaml")
        assertNull(CommandCheck().problem(words(tables)))
        assertTrue("--collect" in words(tables))
        assertEquals(words(job).after("--out"), words(tables).after("--out"))
        for (key in listOf("claimName", "image", "workingDir", "mountPath")) {
            val value = Regex("""\b$key: (\S+)""")
            assertEquals(value.find(job)!!.value, value.find(tables)!!.value)
        }
        val names = Regex("""metadata:\n  name: (.*)""").findAll(job).map { it.groupValues[1] }.toList()
        assertEquals(names[0], Regex("""claimName: (.*)""").find(job)!!.groupValues[1])
        assertTrue(" job/${names[1]} " in Files.readString(Repository.root.resolve("docs/batch.md")))
    }

    @Test
    fun `what Snakemake and row carry out is a command of the program`() {
        val page = Files.readString(Repository.root.resolve("docs/batch.md"))
        val all = RegexOption.DOT_MATCHES_ALL
        val sweep = Regex("""SWEEP = "(.*)"""").find(page)!!.groupValues[1]
        val part = Regex("""\ncommand = "{3}(.*?)"{3}""", all).find(page)!!.groupValues[1]
        for (command in listOf("$sweep --part 1/8", "$sweep --collect", part.replace("{directory}", "1"))) {
            assertNull(CommandCheck().problem(shellCommands(command).first().words)) { command }
        }
    }
}
