package daphnis.analysis.movie

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.plot.drawing
import daphnis.analysis.report.AnalysisProgress
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.REPLACE_EXISTING

/**
 * A movie of all states of [input], a frame each, in order of time. What all frames have in common, such as the range
 * of colours, is found in a first pass over a few states; one state at a time is in memory beside the last. One thread.
 */
public class Movie(private val input: AnalysisInput, private val options: MovieOptions) {
    /**
     * Writes [file], in the format of its name; it appears when it is complete, and replaces one that is there.
     *
     * @return what the frames are like
     * @throws IllegalArgumentException when the name is of no format, or the rate too high for it
     * @throws daphnis.core.format.FormatException when a state cannot be read
     * @throws IllegalStateException when this Java cannot draw
     * @throws IOException when the file cannot be written
     */
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(file: Path, progress: AnalysisProgress = AnalysisProgress { _, _, _ -> }): MovieFrames {
        val format = requireNotNull(MovieFormat.of(file)) { "$file ends in none of .gif, .mp4 and .webm" }
        require(options.framesPerSecond <= format.mostFramesPerSecond) {
            "frames per second are ${options.framesPerSecond}; .${format.extension} takes ${format.mostFramesPerSecond}"
        }
        require(options.colour != MovieColour.SPIN || input.snapshot(input.size - 1).hasSpin) {
            "the colour is that of spins, which these spheres do not have"
        }
        require(options.colour != MovieColour.MATERIAL || input.snapshot(input.size - 1).hasMaterials) {
            "the colour is that of materials, which these spheres do not have"
        }
        val samples = samples()
        val steps = 2 * samples.size + input.size
        val survey = Survey(options.even(format))
        for ((n, k) in samples.withIndex()) {
            progress.next(n, steps, SURVEY)
            survey.look(input.state(k))
        }
        for ((n, k) in samples.withIndex()) {
            progress.next(samples.size + n, steps, SURVEY)
            survey.weigh(input.state(k))
        }
        val scene = survey.scene(input.units, input.omega)
        val done = 2 * samples.size
        val frames = beside(file) { part ->
            drawing {
                frames(scene, format, part) { progress.next(done + it, steps, "frame ${it + 1} of ${input.size}") }
            }
        }
        progress.next(steps, steps, "done")
        return frames
    }

    private fun frames(scene: Scene, format: MovieFormat, file: Path, progress: (Int) -> Unit): MovieFrames {
        val legend = Legend(scene)
        val painter = FramePainter(scene, legend)
        val clock = Clock(scene.scale, input.times)
        val image = painter.image
        format.open(file, image.width, image.height, options.framesPerSecond).use { out ->
            for (k in 0 until input.size) {
                progress(k)
                out.add(painter.paint(input.state(k), clock.text(input.times[k])))
            }
            out.finish()
            return MovieFrames(input.size, image.width, image.height, legend.remark, out.writer)
        }
    }

    /** Some states, evenly, with the first and the last. */
    private fun samples(): List<Int> {
        val count = minOf(input.size, SAMPLES)
        return List(count) { if (count == 1) 0 else (it.toLong() * (input.size - 1) / (count - 1)).toInt() }
    }

    private fun beside(file: Path, write: (Path) -> MovieFrames): MovieFrames {
        val part = file.resolveSibling("${file.fileName}.part")
        // A link of that name, symbolic or hard, would lead what is written elsewhere.
        Files.deleteIfExists(part)
        // An interrupted program leaves nothing behind.
        part.toFile().deleteOnExit()
        try {
            return write(part).also { Files.move(part, file, REPLACE_EXISTING) }
        } finally {
            Files.deleteIfExists(part)
        }
    }

    private companion object {
        const val SAMPLES = 12
        const val SURVEY = "range of the colours"

        fun MovieOptions.even(format: MovieFormat) =
            if (format != MovieFormat.GIF) MovieOptions(view, colour, framesPerSecond, width + width % 2) else this
    }
}

/**
 * What the frames of a movie are like.
 *
 * @property number of them
 * @property width in pixels; one more than asked for where the format needs an even number
 * @property height in pixels, with the legend
 * @property writer the program or library that wrote the file: `ImageIO`, `jcodec` or `ffmpeg`
 * @property enlarged what was enlarged so that a flat box is seen, as `vertical × 5`; null when nothing was
 */
public class MovieFrames internal constructor(
    public val number: Int,
    public val width: Int,
    public val height: Int,
    public val enlarged: String?,
    public val writer: String,
)
