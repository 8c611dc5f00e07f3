package daphnis.app

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO

class MovieCommandTest {
    @TempDir
    lateinit var folder: Path

    private fun run(name: String, vararg words: String): String {
        val path = "${folder.resolve(name)}"
        assertDone(daphnis("run", *words, "--out", path, "--quiet"))
        return path
    }

    private fun movie(vararg words: String) = daphnis("movie", *words, "--quiet")

    @Test
    fun `a gif has a frame per snapshot, and replaces one that is there`() {
        val run = run("gas", "cooling-gas", "--steps", "6", "--set", "output.snapshotEvery=2")
        val said = assertDone(movie(run, "--width", "300"))
        val file = Path.of(run, "plots", "movie.gif")
        // Of the start and of steps 2, 4 and 6; below the square box there is the legend.
        assertTrue(
            "4 frames of 300 × 380 pixels, 4 s at 1 per second" in said &&
                "--fps sets another" in said &&
                "$file" in said,
        ) { said }
        ImageIO.createImageInputStream(file.toFile()).use { input ->
            val reader = ImageIO.getImageReaders(input).next().also { it.input = input }
            assertEquals(4, reader.getNumImages(true))
            assertEquals(300, reader.getWidth(0))
        }
        val first = Files.readAllBytes(file)
        assertDone(movie(run, "--width", "300"))
        assertArrayEquals(first, Files.readAllBytes(file)) { "the same run gives the same movie" }
        assertDone(movie(run, "--width", "300", "--colour", "height", "--view", "side"))
        assertTrue(!first.contentEquals(Files.readAllBytes(file)))
        assertEquals(listOf("movie.gif", "run.png", "run.svg"), file.parent.toFile().list()!!.sorted())
    }

    @Test
    fun `the length of a movie has one decimal`() {
        val run =
            run("many", "cooling-gas", "--steps", "30", "--set", "output.snapshotEvery=1", "--set", "particles.count=9")
        val said = assertDone(movie(run, "--width", "240"))
        assertTrue("31 frames of 240 × " in said && ", 4.4 s at 7 per second," in said) { said }
    }

    @Test
    fun `an mp4 of an odd width has one pixel more`() {
        val run = run("ring", "ring-patch", "--steps", "2", "--set", "output.snapshotEvery=1")
        val file = folder.resolve("ring.MP4")
        val said = assertDone(movie(run, "--width", "301", "--view", "side", "--colour", "density", "--out", "$file"))
        assertTrue("3 frames of 302 × " in said) { said }
        assertTrue("ftyp" in String(Files.readAllBytes(file).copyOf(16), Charsets.ISO_8859_1))
    }

    @Test
    fun `a flat box is enlarged, and that is said`() {
        val flat = arrayOf("--set", "box.lengths=[1500,1500,60]", "--set", "output.snapshotEvery=1")
        val run = run("flat", "ring-patch", "--steps", "1", "--set", "particles.opticalDepth=0.05", *flat)
        val said = assertDone(movie(run, "--view", "side", "--width", "300"))
        assertTrue(Regex("the box is drawn with its vertical × 5, and every frame says so").containsMatchIn(said)) {
            said
        }
        assertTrue("drawn with" !in assertDone(movie(run, "--width", "300")))
    }

    @Test
    fun `what is wrong is told in one line`() {
        val run = run("gas", "cooling-gas", "--steps", "1", "--set", "output.snapshotEvery=1")
        assertRefused(movie(run, "--width", "239"), "--width", "is 239", "240")
        assertRefused(movie(run, "--width", "5000"), "--width", "4096")
        assertRefused(movie(run, "--fps", "60"), "--fps", "50", ".gif")
        assertRefused(movie(run, "--fps", "0"), "--fps", "is 0")
        assertRefused(movie(run, "--fps", "NaN"), "--fps")
        assertRefused(movie(run, "--out", "movie.avi"), "--out", "movie.avi", ".gif, .mp4 or .webm")
        assertRefused(movie(run, "--out", ""), "--out", "empty")
        Files.createDirectories(folder.resolve("folder.gif"))
        assertRefused(movie(run, "--out", "${folder.resolve("folder.gif")}"), "--out", "is a directory")
        assertRefused(movie(run, "--view", "front"), "--view", "front")
        assertRefused(movie(run, "--colour", "mood"), "--colour", "mood")
        assertRefused(movie(run, "--colour", "spin"), "--colour", "is spin", "have none")
        assertRefused(movie(run, "--colour", "material"), "--colour", "is material", "have none")
        assertRefused(movie("${folder.resolve("none")}"), "none", "no such")
        val without = run("without", "cooling-gas", "--steps", "1", "--set", "output.snapshotEvery=0")
        Files.list(Path.of(without, "snapshots")).use { files -> files.toList().forEach(Files::delete) }
        assertRefused(movie(without), "no snapshots", "output.snapshotEvery")
    }

    @Test
    fun `a damaged snapshot ends it, and nothing half-written is left`() {
        val run = run("gas", "cooling-gas", "--steps", "40", "--set", "output.snapshotEvery=1")
        // One that is not among the samples, so that frames were written before it.
        val damaged = Path.of(run, "snapshots", "0000000002.h5")
        val bytes = Files.readAllBytes(damaged)
        bytes[bytes.size / 2] = (bytes[bytes.size / 2] + 1).toByte()
        Files.write(damaged, bytes)
        assertRefused(movie(run, "--width", "300"), "0000000002.h5")
        assertEquals(listOf("run.png", "run.svg"), Path.of(run, "plots").toFile().list()!!.sorted())
    }

    @Test
    fun `discs have no side and no height, and are told so`() {
        val small = arrayOf("--set", "particles.count=20", "--set", "box.lengths=[12,12]")
        val said = assertDone(daphnis("run", "hard-discs", "--until", "0.5", *small, "--out", "${folder.resolve("d")}"))
        assertTrue("20 discs, " in said) { said }
        val run = "${folder.resolve("d")}"
        assertTrue("--view: is side; it must be another: $run is of discs" in movie(run, "--view", "side").err)
        assertTrue("--colour: is height; it must be another" in movie(run, "--colour", "height").err)
        assertDone(movie(run, "--width", "240"))
    }
}
