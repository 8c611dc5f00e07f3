package daphnis.analysis.movie

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledOnOs
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir
import java.awt.image.BufferedImage
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs

/** With scripts in place of the program, and with the program where it is. */
@DisabledOnOs(OS.WINDOWS)
class FfmpegFileTest {
    @TempDir
    lateinit var home: Path

    /** A program of the name `ffmpeg` in a folder of its own, which does [what] with the frames. */
    private fun script(what: String): Path {
        val folder = Files.createTempDirectory(home, "bin")
        val file = folder.resolve("ffmpeg")
        val encoders = "case \"$*\" in *-encoders*) echo ' V....D libx264  H.264'; echo ' A....D aac  AAC'; exit;; esac"
        Files.writeString(file, "#!/bin/sh\n$encoders\nfor last; do :; done; out=\${last#file:}\n$what\n")
        assertTrue(file.toFile().setExecutable(true))
        return folder
    }

    private fun found(what: String): Ffmpeg = checkNotNull(Ffmpeg.find("${home.resolve("none")}:${script(what)}"))

    private fun open(program: Ffmpeg, file: Path = home.resolve("a.mp4"), side: Int = 64) =
        FfmpegFile(program, file, side, side, 12.5, listOf("-c:v", "libx264", "-crf", "18", "-f", "mp4"))

    private fun picture(side: Int, rgb: Int) = BufferedImage(side, side, BufferedImage.TYPE_INT_RGB).apply {
        for (y in 0 until side) for (x in 0 until side) setRGB(x, y, rgb)
    }

    @Test
    fun `it is found by its name on the path, with its encoders of video`() {
        assertEquals(setOf("libx264"), found("exit 0").encoders)
        assertNull(Ffmpeg.find(null))
        assertNull(Ffmpeg.find("$home:"))
        val broken = script("exit 0").resolve("ffmpeg")
        Files.writeString(broken, "#!/bin/sh\nexit 3\n")
        assertNull(Ffmpeg.find("${broken.parent}"))
        Files.writeString(broken, "no program")
        assertNull(Ffmpeg.find("${broken.parent}"))
    }

    @Test
    fun `it gets the pixels of all frames, blue first, and writes the file`() {
        val file = home.resolve("a b.mp4")
        open(found("cat >\"\$out\""), file, side = 2).use { out ->
            out.add(picture(2, 0x123456))
            out.add(picture(2, 0xabcdef))
            out.finish()
        }
        val first = List(4) { listOf(0x56, 0x34, 0x12, -1) }.flatten()
        val second = List(4) { listOf(0xef, 0xcd, 0xab, -1) }.flatten()
        val seen = Files.readAllBytes(file)
        assertEquals(32, seen.size)
        for ((k, wanted) in (first + second).withIndex()) if (wanted >= 0) assertEquals(wanted.toByte(), seen[k])
    }

    @Test
    fun `what it says as it fails is told, at once or in the end`() {
        val early = found("echo first >&2; echo 'Unknown encoder' >&2; exit 1")
        val told = assertThrows(IOException::class.java) {
            // More than a pipe holds.
            open(early, side = 512).use { out -> repeat(8) { out.add(picture(512, it)) } }
        }
        assertTrue("ffmpeg failed: Unknown encoder" in told.message!!) { "$told" }
        val none = assertThrows(IOException::class.java) {
            open(found("exit 0"), side = 512).use { out -> repeat(8) { out.add(picture(512, it)) } }
        }
        assertTrue("ended before the last frame" in none.message!!) { "$none" }
        val late = found("cat >/dev/null; exit 7")
        val end = assertThrows(IOException::class.java) {
            open(late).use { out ->
                out.add(picture(64, 0))
                out.finish()
            }
        }
        assertTrue("exit status 7" in end.message!!) { "$end" }
    }

    @Test
    fun `one that is not finished is stopped`() {
        val pid = home.resolve("pid")
        val program = found("echo $$ >'$pid.part'; mv '$pid.part' '$pid'; exec cat >/dev/null")
        open(program).use { out -> out.add(picture(64, 0)) }
        // It may not have come as far as to say who it is.
        if (Files.exists(pid)) {
            assertFalse(ProcessHandle.of(Files.readString(pid).trim().toLong()).map { it.isAlive }.orElse(false))
        }
    }

    @Test
    fun `the program itself gives colours as they were`() {
        val program = Ffmpeg.onPath
        assumeTrue(program != null && "libx264" in program.encoders, "no ffmpeg here")
        val file = home.resolve("a.mp4")
        val colours = listOf(0x10141c, 0xd04030, 0x3080e0)
        open(program!!, file).use { out ->
            for (rgb in colours) out.add(picture(64, rgb))
            out.finish()
        }
        val words =
            listOf("${program.path}", "-loglevel", "error", "-i", "$file", "-f", "rawvideo", "-pix_fmt", "rgb24")
        val back = ProcessBuilder(words + "-").redirectError(ProcessBuilder.Redirect.DISCARD).start()
        val bytes = back.inputStream.readAllBytes()
        assertEquals(3 * 64 * 64 * 3, bytes.size)
        for ((k, rgb) in colours.withIndex()) {
            for ((n, shift) in listOf(16, 8, 0).withIndex()) {
                val seen = bytes[(k * 64 * 64 + 64 * 32 + 32) * 3 + n].toInt() and 0xff
                assertTrue(abs(seen - (rgb shr shift and 0xff)) <= 4) { "%06x: %d %d".format(rgb, n, seen) }
            }
        }
    }
}
