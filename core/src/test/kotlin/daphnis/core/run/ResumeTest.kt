package daphnis.core.run

import daphnis.core.input.InputException
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** What a checkpoint vouches for: resume goes on to the same files, or says what is not as it was. */
@Tag("jdk-neutral")
class ResumeTest {
    @TempDir
    lateinit var home: Path

    private val whole by lazy {
        startIn(home.resolve("whole")).toStep(Long.MAX_VALUE)
        results(home.resolve("whole"))
    }

    /** Checkpoints after steps 6 and 8, the end. */
    private val broken by lazy { home.resolve("broken").also { startIn(it).toStep(8) } }

    private fun damaged(name: String, damage: (Path) -> Unit): Path = copyOf(broken, home.resolve(name)).also(damage)

    private fun resume(directory: Path, acceptLoss: Boolean = false): List<String> =
        Run.resume(directory, acceptLoss = acceptLoss).use { run -> run.notices.also { run.execute() } }

    private fun refusal(directory: Path): String {
        val before = bytesIn(directory)
        val message = assertThrows(InputException::class.java) { resume(directory) }.message.orEmpty()
        assertFalse('\n' in message) { message }
        assertEquals(before, bytesIn(directory)) { "a refused resume changes nothing" }
        return message
    }

    @Tag("thorough")
    @Test
    fun `killed between any two operations on files, a run goes on to the same files`() {
        var n = 0
        val mortal = ArrayList<String>()
        while (true) {
            val files = MortalFiles(n)
            val directory = home.resolve("killed-$n")
            try {
                startIn(directory, files = files).toStep(Long.MAX_VALUE)
                break
            } catch (e: Killed) {
                mortal += files.operations.lastOrNull().orEmpty()
            }
            if (Files.exists(directory.resolve("scenario.json"))) {
                assertEquals(emptyList<String>(), resume(directory)) { "after ${files.operations}" }
            } else {
                startIn(directory).toStep(Long.MAX_VALUE)
            }
            assertEquals(whole, results(directory)) { "after ${files.operations}" }
            n++
        }
        assertTrue("move checkpoint to checkpoint.previous" in mortal && "force series.csv" in mortal && n > 50) {
            mortal.toString()
        }
    }

    @Test
    fun `killed in a resume that had to take the previous checkpoint, it still can`() {
        for (n in 0 until 16) {
            val directory = damaged("again-$n") { flip(it.resolve("checkpoint"), 200) }
            val files = MortalFiles(n)
            assertThrows(Killed::class.java) {
                resumeRun(RunDirectory(directory, files), null, daphnis.core.Engines, false).toStep(Long.MAX_VALUE)
            }
            resume(directory)
            assertEquals(whole, results(directory)) { "after ${files.operations}" }
        }
    }

    @Test
    fun `a directory in the place of a checkpoint is named`() {
        for (name in listOf("checkpoint", "checkpoint.previous")) {
            val directory = damaged("directory-for-$name") {
                Files.delete(it.resolve(name))
                Files.createDirectory(it.resolve(name))
            }
            val message = assertThrows(InputException::class.java) { resume(directory) }.message.orEmpty()
            assertTrue("$name: is not a file" in message && '\n' !in message) { message }
        }
    }

    @Tag("thorough")
    @Test
    fun `a table that is shorter or changed before both checkpoints is refused by name, and accepted on request`() {
        val damages = listOf<Pair<String, (Path) -> Unit>>(
            "cut" to { cut(it, 150) },
            "flipped" to { flip(it, 130) },
            "empty" to { cut(it, 0) },
            "gone" to { Files.delete(it) },
        )
        for (table in listOf("series.csv", "transport.csv", "collisions.csv")) {
            for ((name, damage) in damages) {
                val directory = damaged("$table-$name") { damage(it.resolve(table)) }
                val message = refusal(directory)
                assertTrue(table in message && "continue with what is there" in message) { message }
                val notices = resume(directory, acceptLoss = true)
                assertTrue(notices.any { table in it && ("lost" in it || "as they are" in it) }) { notices.toString() }
                assertEquals(whole["digest"], results(directory)["digest"])
                for ((other, text) in whole) {
                    if (other != table) {
                        assertEquals(text, results(directory)[other]) { "$other beside a $name $table" }
                    }
                }
                val lines = Files.readAllLines(directory.resolve(table))
                assertEquals(whole.getValue(table).lines().dropLast(1).last(), lines.last()) { "$name $table" }
                val loss = notices.filter { "/$table: " in it }
                assertEquals(
                    loss,
                    resume(directory).filter {
                        "/$table: " in it
                    },
                ) { "accepted is accepted, and said again" }
                assertEquals(loss, RunRecord.of(RunDirectory(directory)).losses)
            }
        }
    }

    @Test
    fun `a table that lost what came after the previous checkpoint is written again`() {
        val known = Checkpoint.read(
            RunDirectory(broken).previousCheckpoint,
        ).meta.appended.getValue("series.csv").length.toInt()
        for ((name, damage) in listOf<Pair<String, (Path) -> Unit>>(
            "cut" to { cut(it, known + 3) },
            "flipped" to { flip(it, known + 3) },
        )) {
            val directory = damaged("later-$name") { damage(it.resolve("series.csv")) }
            val notices = resume(directory)
            assertTrue(
                notices.any {
                    "series.csv" in it
                } &&
                    notices.any { "checkpoint.previous" in it && "step 6" in it },
            ) { notices.toString() }
            assertEquals(whole, results(directory))
        }
    }

    private fun edited(name: String, old: String, new: String): Path = damaged(name) {
        val file = it.resolve("scenario.json")
        val text = Files.readString(file)
        assertTrue(old in text) { text }
        Files.writeString(file, text.replace(old, new))
    }

    @Test
    fun `a scenario changed in what makes the run is refused with key and values`() {
        val changes = listOf(
            Triple(
                "\"coefficient\": 0.6",
                "\"coefficient\": 0.7",
                "restitution.coefficient: is 0.7; the run was made with 0.6",
            ),
            Triple("\"dt\": 0.1", "\"dt\": 0.05", "timeStep.dt: is 0.05; the run was made with 0.1"),
            Triple("7.0,", "8.0,", "box.lengths[0]: is 8.0; the run was made with 7.0"),
            Triple("\"collisionLog\": true", "\"collisionLog\": false", "output.collisionLog"),
            Triple("\"transportEvery\": 2", "\"transportEvery\": 0", "output.transportEvery"),
            Triple("\"seed\": 3", "\"seed\": 4", "seed"),
        )
        for ((k, change) in changes.withIndex()) {
            val message = refusal(edited("essential-$k", change.first, change.second))
            assertTrue(change.third in message && "scenario.json" in message) { message }
        }
    }

    @Test
    fun `a scenario changed in what touches no bit goes on, and says so`() {
        val changes = listOf(
            "\"name\": \"serial\"" to "\"name\": \"islands\"",
            "\"name\": \"tables\"" to "\"name\": \"chairs\"",
            "\"checkpointEvery\": 3" to "\"checkpointEvery\": 4",
        )
        for ((k, change) in changes.withIndex()) {
            val directory = edited("harmless-$k", change.first, change.second)
            val notices = resume(directory)
            assertEquals(1, notices.size) { notices.toString() }
            assertTrue("scenario.json" in notices[0] && "the run was made with" in notices[0]) { notices.toString() }
            assertEquals(whole, results(directory))
        }
        val longer = edited("longer", "\"until\": 1.2", "\"until\": 1.4")
        assertTrue("until: is 1.4; the run was made with 1.2" in resume(longer).single())
        assertEquals(14L, Summary.read(RunDirectory(longer).summary).steps)
    }

    @Tag("thorough")
    @Test
    fun `a resume to another end is the run of that end, wherever it is killed`() {
        val made = "made for this; changed: a=1, steps=12, seed=4"
        val before = home.resolve("before")
        startIn(before, tableScenario().copy(description = made)).toStep(Long.MAX_VALUE)
        val longer = home.resolve("longer-at-once")
        val asOne = "made for this; changed: a=1, until=1.6, seed=4"
        startIn(longer, tableScenario("until=1.6").copy(description = asOne)).toStep(Long.MAX_VALUE)
        var n = 0
        do {
            val directory = copyOf(before, home.resolve("longer-$n"))
            val run = RunDirectory(directory, MortalFiles(n++))
            val isKilled = try {
                resumeRun(run, 1.6, daphnis.core.Engines, false).toStep(Long.MAX_VALUE)
                false
            } catch (e: Killed) {
                true
            }
            val end = ScenarioJson.read(run.scenario).until
            if (Files.exists(run.summary)) assertEquals(end!!, Summary.read(run.summary).time, 1e-9) { "killed at $n" }
            if (isKilled) Run.resume(directory, if (end == 1.6) null else 1.6).toStep(Long.MAX_VALUE)
            assertEquals(results(longer), results(directory)) { "killed at $n" }
            assertEquals(Files.readString(longer.resolve("scenario.json")), Files.readString(run.scenario))
            assertEquals(emptyList<String>(), resume(directory)) { "the checkpoint knows the new end" }
        } while (isKilled)
        assertTrue(n > 10) { "$n" }
    }

    @Test
    fun `resumed to an earlier end that is still to come, a run is complete there`() {
        val directory = damaged("earlier") {}
        Run.resume(directory, until = 1.0).toStep(Long.MAX_VALUE)
        val run = RunDirectory(directory)
        assertEquals(1.0, ScenarioJson.read(run.scenario).until)
        assertTrue(Summary.read(run.summary).finished)
        val text = Files.readString(run.scenario)
        assertThrows(InputException::class.java) { Run.resume(directory, until = 0.5) }
        assertEquals(text, Files.readString(run.scenario)) { "a refused resume changes nothing" }
    }

    @Test
    fun `readers are told what is not as the run wrote it`() {
        startIn(home.resolve("done")).toStep(Long.MAX_VALUE)
        val run = RunDirectory(home.resolve("done"))
        val files = listOf(run.series, run.transport, run.impacts, run.summary)
        assertEquals(emptyList<String>(), RunRecord.of(run).problems(*files.toTypedArray()))
        for (file in files) {
            val good = Files.readAllBytes(file)
            flip(file, good.size / 2)
            assertTrue("$file" in RunRecord.of(run).problems(*files.toTypedArray()).single())
            cut(file, good.size - 1)
            assertTrue("$file" in RunRecord.of(run).problems(*files.toTypedArray()).single())
            Files.write(file, good)
        }
        flip(run.checkpoint, 30)
        flip(run.series, 40)
        assertTrue("series.csv" in RunRecord.of(run).problems(run.series).single()) {
            "the previous checkpoint knows it too"
        }
        flip(run.previousCheckpoint, 30)
        assertEquals(emptyList<String>(), RunRecord.of(run).problems(run.series))
    }

    @Test
    fun `a live run is no damaged one`() {
        val directory = home.resolve("live")
        startIn(directory).use { run ->
            val place = RunDirectory(directory)
            run.execute({
                val record = RunRecord.of(place)
                assertEquals(
                    emptyList<String>(),
                    record.problems(place.series, place.transport, place.impacts, place.summary),
                )
                assertTrue(place.snapshotSteps().all { place.readSnapshot(it).step == it })
            })
        }
    }

    @Test
    fun `a finished run that cannot be resumed keeps its summary`() {
        val directory = home.resolve("a")
        startIn(directory).use { it.execute() }
        val summary = Files.readString(RunDirectory(directory).summary)
        Files.move(RunDirectory(directory).snapshots, directory.resolve("elsewhere"))
        Files.writeString(RunDirectory(directory).snapshots, "in the way")
        assertThrows(RunException::class.java) { Run.resume(directory).close() }
        assertEquals(summary, Files.readString(RunDirectory(directory).summary))
    }

    @Test
    fun `a finished run whose last state is damaged gets it back`() {
        val directory = home.resolve("finished")
        startIn(directory).toStep(Long.MAX_VALUE)
        cut(RunDirectory(directory).snapshot(12), 900)
        resume(directory)
        assertEquals(whole, results(directory))
    }
}
