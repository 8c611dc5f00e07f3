package daphnis.core.run

import daphnis.core.scenario.InputException
import kotlinx.serialization.json.Json
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
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
    fun `a version that is not known is passed over, with a notice, for the checkpoint before`() {
        val directory = broken()
        for (version in listOf(2, 99)) {
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
        assertTrue("format 99" in e.message.orEmpty()) { e.message }
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
        ) { "the next checkpoint is of format 3" }
        cut(short.series, 20)
        assertTrue("series.csv" in assertThrows(InputException::class.java) { digest(short) }.message.orEmpty())
    }

    /** What the version before wrote: no scenario, lengths of the files only. */
    private fun asFormat2(file: Path): ByteArray {
        val checkpoint = Checkpoint.read(file)
        val m = checkpoint.meta
        val old = CheckpointMeta2(
            m.step, m.time, m.collisions, m.wallCollisions, m.guardActivations, m.redoneSteps, m.causalityReplays,
            m.wallSeconds, m.appended.mapValues { it.value.length }, m.collisionSums, m.impactSpeeds,
        )
        val bytes = ByteArrayOutputStream()
        RecordWriter(DataOutputStream(bytes)).text("META", Json.encodeToString(CheckpointMeta2.serializer(), old))
        val head = bytes.toByteArray().also { it[11] = 2 }
        val text = String(Files.readAllBytes(file), Charsets.ISO_8859_1)
        return head + text.substring(text.indexOf("IDS ")).toByteArray(Charsets.ISO_8859_1)
    }
}
