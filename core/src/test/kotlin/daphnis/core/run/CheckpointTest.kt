package daphnis.core.run

import daphnis.core.collision.Counter
import daphnis.core.input.InputException
import daphnis.core.table.UnitsOfDimensions
import kotlinx.serialization.json.Json
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path

class CheckpointTest {
    @TempDir
    lateinit var home: Path

    private fun broken(name: String = "broken"): RunDirectory = RunDirectory(home.resolve(name)).also {
        startIn(it.path).toStep(8)
    }

    private fun digest(directory: RunDirectory): String = Run.resume(directory.path).use { it.execute().stateDigest }

    private val whole by lazy { startIn(home.resolve("whole")).toStep(Long.MAX_VALUE).stateDigest }

    @Test
    fun `counts stand at the top of the file's text, and none of the trajectory's may be missing`() {
        val meta = CheckpointMeta(7, 0.5, Counter.entries.associate { it.key to 10L + it.ordinal }, 1.5)
        val text = Json.encodeToString(CheckpointMeta.FILED, meta)
        assertTrue("\"step\":7" in text && "\"wallCollisions\":11" in text && "counted" !in text) { text }
        assertEquals(meta.counted, Json.decodeFromString(CheckpointMeta.FILED, text).counted)
        for (counter in Counter.entries) {
            val less = text.replace(Regex(",?\"${counter.key}\":\\d+"), "")
            val read = runCatching { Json.decodeFromString(CheckpointMeta.FILED, less) }
            assertEquals(counter.isOfTrajectory && !counter.isNew, read.isFailure) { "$counter: $less" }
        }
    }

    @Test
    fun `no flipped bit and no cut passes`() {
        val file = broken().checkpoint
        val good = Files.readAllBytes(file)
        for (at in good.indices step 7) {
            Files.write(file, good.copyOf().also { it[at] = (it[at].toInt() xor (1 shl at % 8)).toByte() })
            val e =
                assertThrows(CheckpointException::class.java, { Checkpoint.read(file) }) { "bit ${at % 8} of byte $at" }
            assertFalse('\n' in e.message.orEmpty())
            Files.write(file, good.copyOf(at))
            assertThrows(CheckpointException::class.java, { Checkpoint.read(file) }) { "cut to $at" }
        }
    }

    @Test
    fun `every bit of the version, the lengths and the names counts`() {
        val file = broken().checkpoint
        val good = Files.readAllBytes(file)
        for (bit in 0 until 8 * 24) {
            Files.write(file, good.copyOf().also { it[bit / 8] = (it[bit / 8].toInt() xor (1 shl bit % 8)).toByte() })
            assertThrows(CheckpointException::class.java, { Checkpoint.read(file) }) { "bit $bit" }
        }
    }

    @Test
    fun `every bit of the names counts, also of records that need not be there`() {
        val file = broken().checkpoint
        val good = Files.readAllBytes(file)
        val text = String(good, Charsets.ISO_8859_1)
        for (name in listOf("SCEN", "IDS ", "POSX", "IMGZ", "OUTS", "END.")) {
            val at = text.lastIndexOf(name)
            for (bit in 0 until 32) {
                Files.write(file, good)
                flip(file, at + bit / 8, bit % 8)
                val e = assertThrows(CheckpointException::class.java, { Checkpoint.read(file) }) { "$name, bit $bit" }
                assertTrue("damaged" in e.message.orEmpty() || "cut short" in e.message.orEmpty()) { e.message }
            }
        }
    }

    @Test
    fun `a record that was taken out is missed, whichever it is`() {
        val file = broken().checkpoint
        val good = Files.readAllBytes(file)
        var at = HEADER
        while (at < good.size) {
            val name = String(good, at, 4, Charsets.ISO_8859_1)
            val end = at + NAME_AND_LENGTH + ByteBuffer.wrap(good).getLong(at + 4).toInt() + CHECKSUM
            Files.write(file, good.copyOf(at) + good.copyOfRange(end, good.size))
            assertThrows(CheckpointException::class.java, { Checkpoint.read(file) }) { name }
            at = end
        }
        assertEquals(good.size, at)
    }

    @Test
    fun `a version that is not known is passed over, with a notice, for the checkpoint before`() {
        val directory = broken()
        for (version in listOf(1, 99)) {
            val run = RunDirectory(copyOf(directory.path, home.resolve("version-$version")))
            Files.write(run.checkpoint, Files.readAllBytes(run.checkpoint).also { it[11] = version.toByte() })
            Run.resume(run.path).use {
                assertTrue("checkpoint" in it.notices[0] && "format $version" in it.notices[0]) {
                    it.notices.toString()
                }
                assertTrue("checkpoint.previous, step 6" in it.notices[1]) { it.notices.toString() }
                assertEquals(whole, it.execute().stateDigest)
            }
        }
        for (file in listOf(directory.checkpoint, directory.previousCheckpoint)) {
            Files.write(
                file,
                Files.readAllBytes(file).also {
                    it[11] =
                        99
                },
            )
        }
        val e = assertThrows(InputException::class.java) { Run.resume(directory.path) }
        assertTrue("newer version of daphnis, format 99" in e.message.orEmpty()) { e.message }
    }

    @Test
    fun `format 2 is read, with a notice, and lengths are held to`() {
        val directory = broken()
        for (file in listOf(directory.checkpoint, directory.previousCheckpoint)) Files.write(file, asFormat2(file))
        val short = RunDirectory(copyOf(directory.path, home.resolve("short")))
        Run.resume(directory.path).use {
            assertTrue("format 2" in it.notices.single() && "not checked" in it.notices.single()) {
                it.notices.toString()
            }
            assertEquals(whole, it.execute().stateDigest)
        }
        assertEquals(
            emptyList<String>(),
            Run.resume(directory.path).use {
                it.notices
            },
        ) { "the next checkpoint is of the present format" }
        cut(short.series, 20)
        assertTrue("series.csv" in assertThrows(InputException::class.java) { digest(short) }.message.orEmpty())
    }

    /** Written by daphnis of commit ceda0ee, in a run of [tableScenario] until 0.8. */
    private fun format3(name: String): RunDirectory {
        val path = Files.createDirectories(home.resolve(name))
        for (file in listOf("scenario.json", "checkpoint", "series.csv", "transport.csv", "collisions.csv")) {
            val stream = checkNotNull(javaClass.getResourceAsStream("/daphnis/format3/$file")) { file }
            stream.use { Files.copy(it, path.resolve(file)) }
        }
        return RunDirectory(path)
    }

    /** [table] with the head that it had before heads had units. */
    private fun withoutUnits(table: String): String {
        val head = table.substringBefore('\n')
        return head.split(',').joinToString(",", transform = UnitsOfDimensions::nameIn) + table.removePrefix(head)
    }

    @Test
    fun `format 3, with sums of transport among the numbers, goes on to the same files`() {
        val directory = format3("old")
        val old = Checkpoint.read(directory.checkpoint)
        assertEquals(setOf("transport"), old.outputs.keys)
        assertEquals(33.0, old.outputs.getValue("transport").doubles("collisionSums")[0])
        Run.resume(directory.path, until = 1.2).use {
            assertEquals(8L, it.resumedFrom)
            assertEquals(emptyList<String>(), it.notices)
            assertEquals(whole, it.execute().stateDigest)
        }
        val expected = results(home.resolve("whole"))
        val found = results(directory.path)
        for (table in listOf("series.csv", "transport.csv", "impacts.csv", "collisions.csv")) {
            assertEquals(withoutUnits(expected.getValue(table)), withoutUnits(found.getValue(table))) { table }
        }
        fun saved(run: RunDirectory) = Checkpoint.read(run.checkpoint).outputs.getValue("transport")
        val sums = saved(RunDirectory(home.resolve("whole"))).doubles("collisionSums")
        assertTrue(sums.size > 13) { "remainders of rounding are among them" }
        assertArrayEquals(sums, saved(directory).doubles("collisionSums"))
    }

    @Test
    fun `readers know what format 3 knows of the tables`() {
        val directory = format3("old")
        assertEquals(emptyList<String>(), RunRecord.of(directory).problems(directory.series, directory.transport))
        flip(directory.transport, 700)
        assertTrue("transport.csv" in RunRecord.of(directory).problems(directory.transport).single())
    }

    /** What format 2 has: no scenario, lengths of the files only. */
    private fun asFormat2(file: Path): ByteArray {
        val checkpoint = Checkpoint.read(file)
        val m = checkpoint.meta
        val transport = checkpoint.outputs.getValue("transport")
        val old = OlderMeta(
            m.step,
            m.time,
            m.counted,
            m.wallSeconds,
            collisionSums = transport.doubles("collisionSums").asList(),
            impactSpeeds = transport.longs("impactSpeeds").asList(),
            fileLengths = m.appended.mapValues { it.value.length },
        )
        val bytes = ByteArrayOutputStream()
        RecordWriter(DataOutputStream(bytes)).text("META", Json.encodeToString(OlderMeta.FILED, old))
        val head = bytes.toByteArray().also { it[11] = 2 }
        val text = String(Files.readAllBytes(file), Charsets.ISO_8859_1)
        val spheres = text.substring(text.indexOf("IDS "), text.indexOf("OUTS"))
        return head + (spheres + text.substring(text.indexOf("END."))).toByteArray(Charsets.ISO_8859_1)
    }

    private companion object {
        /** Bytes of the mark of the format and of its version. */
        const val HEADER = 12
        const val NAME_AND_LENGTH = 12
        const val CHECKSUM = 4
    }
}
