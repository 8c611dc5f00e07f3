package daphnis.analysis.movie

import java.awt.image.BufferedImage
import java.awt.image.DataBufferInt
import java.io.File
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit

/**
 * A movie by the program `ffmpeg`, to which the frames go as they are. It ends with this file: what fails there fails
 * here, and what is not finished is stopped.
 *
 * @param options of its encoder
 */
internal class FfmpegFile(
    private val program: Ffmpeg,
    path: Path,
    private val width: Int,
    private val height: Int,
    framesPerSecond: Double,
    options: List<String>,
) : MovieFile {
    override val writer: String = "ffmpeg"
    private val said: Path = Files.createTempFile("daphnis-ffmpeg", ".log").also { it.toFile().deleteOnExit() }
    private val process: Process

    /** A program that ends at a signal closes nothing. */
    private val stop = Thread { process.destroyForcibly() }
    private val bytes = ByteBuffer.allocate(Int.SIZE_BYTES * width * height).order(ByteOrder.LITTLE_ENDIAN)
    private val pixels = bytes.asIntBuffer()

    init {
        // Colours as BT.709, as every player of today takes them, and said so. No date is written.
        val input = listOf("-f", "rawvideo", "-pix_fmt", "bgr0", "-s", "${width}x$height", "-r", "$framesPerSecond")
        val colours = listOf("-vf", "scale=out_color_matrix=bt709:out_range=tv", "-pix_fmt", "yuv420p") +
            listOf("-colorspace", "-color_primaries", "-color_trc").flatMap { listOf(it, "bt709") }
        val words = listOf("${program.path}", "-nostdin", "-loglevel", "error", "-y") + input + listOf("-i", "pipe:0") +
            colours + options + listOf("-fflags", "+bitexact", "-flags:v", "+bitexact", "file:${path.toAbsolutePath()}")
        process = try {
            ProcessBuilder(words).redirectOutput(ProcessBuilder.Redirect.DISCARD).redirectError(said.toFile()).start()
        } catch (e: IOException) {
            Files.deleteIfExists(said)
            throw e
        }
        Runtime.getRuntime().addShutdownHook(stop)
    }

    override fun add(image: BufferedImage) {
        pixels.clear()
        pixels.put((image.raster.dataBuffer as DataBufferInt).data)
        try {
            process.outputStream.write(bytes.array())
        } catch (e: IOException) {
            // It went before its time, and has said why.
            throw failed(e)
        }
    }

    override fun finish() {
        try {
            process.outputStream.close()
        } catch (e: IOException) {
            throw failed(e)
        }
        if (process.waitFor() != 0) throw failed(null)
    }

    private fun failed(cause: IOException?): IOException {
        if (!process.waitFor(PATIENCE, TimeUnit.SECONDS)) process.destroyForcibly().waitFor()
        val last = Files.readAllLines(said, Charsets.ISO_8859_1).lastOrNull { it.isNotBlank() }
        val status = process.exitValue()
        val why = last?.trim() ?: if (status == 0) "it ended before the last frame" else "exit status $status"
        return IOException("${program.path} failed: $why", cause)
    }

    override fun close() {
        if (process.isAlive) process.destroyForcibly().waitFor()
        Files.deleteIfExists(said)
        try {
            Runtime.getRuntime().removeShutdownHook(stop)
        } catch (_: IllegalStateException) {
            // The program is ending, and the hook has its turn.
        }
    }

    private companion object {
        /** Seconds in which a program that takes no more frames ends. */
        const val PATIENCE = 5L
    }
}

/**
 * The program `ffmpeg`.
 *
 * @property path where it is
 * @property encoders of video that it was built with
 */
internal class Ffmpeg private constructor(val path: Path, val encoders: Set<String>) {
    companion object {
        /** Looked for once. */
        val onPath: Ffmpeg? by lazy { find() }

        /** The first of that name in the directories [path]; null when there is none that says what it can. */
        fun find(path: String? = System.getenv("PATH")): Ffmpeg? {
            val names = listOf("ffmpeg", "ffmpeg.exe")
            val file = path.orEmpty().split(File.pathSeparatorChar).filter { it.isNotEmpty() }
                .flatMap { folder -> names.map { File(folder, it) } }.firstOrNull { it.isFile && it.canExecute() }
            return file?.let { encoders(it) }?.let { Ffmpeg(file.toPath(), it) }
        }

        private fun encoders(program: File): Set<String>? = try {
            val process = ProcessBuilder("$program", "-nostdin", "-hide_banner", "-encoders")
                .redirectError(ProcessBuilder.Redirect.DISCARD).start()
            process.outputStream.close()
            val asked = CompletableFuture.supplyAsync { process.inputReader().readLines() }
            // One that does not answer is none.
            val lines = asked.completeOnTimeout(null, PATIENCE, TimeUnit.SECONDS).get()
            if (lines == null || !process.waitFor(PATIENCE, TimeUnit.SECONDS)) process.destroyForcibly()
            val isGood = lines != null && process.waitFor() == 0
            if (isGood) lines!!.mapNotNull { ENCODER.find(it)?.groupValues?.get(1) }.toSet() else null
        } catch (_: IOException) {
            null
        } catch (_: ExecutionException) {
            null
        }

        /** Seconds in which it says what it can. */
        private const val PATIENCE = 10L
        private val ENCODER = Regex("""^ V\S+ (\S+)""")
    }
}
