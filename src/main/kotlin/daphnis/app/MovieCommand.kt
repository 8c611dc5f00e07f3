package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.movie.Movie
import daphnis.analysis.movie.MovieColour
import daphnis.analysis.movie.MovieFormat
import daphnis.analysis.movie.MovieFrames
import daphnis.analysis.movie.MovieOptions
import daphnis.analysis.movie.MovieView
import daphnis.analysis.report.AnalysisProgress
import daphnis.app.printing.printLine
import daphnis.app.printing.warn
import daphnis.app.progress.ShownProgress
import daphnis.core.input.InputException
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.run.RunException
import java.nio.file.Files
import java.nio.file.Path
import java.util.Locale

/** `daphnis movie`: the snapshots of a run, one after the other. */
class MovieCommand : CliktCommand(name = "movie") {
    private val directory by argument("dir", help = "run directory", completionCandidates = Candidates.files)
    private val view by option("--view", help = "from above (top, default) or along x (side)")
        .choice(MovieView.entries.associateBy { it.word }).default(MovieView.TOP)
    private val colour by option(
        "--colour",
        "--color",
        help = "what the colour means: speed against the mean flow (default), spin, size, height, material or " +
            "surface density",
    ).choice(MovieColour.entries.associateBy { it.word }).default(MovieColour.SPEED)
    private val fps by option(
        "--fps",
        help = "frames per second (default 25, or fewer so that few frames last about 4 s)",
    ).double()
    private val width by option("--width", help = "width of the frames in pixels, 240 to 4096 (default 1200)")
        .int().default(1200)
    private val out by option(
        "--out",
        metavar = "file",
        help = "where to write, a name that ends in .gif, .mp4 or .webm (default: DIR/plots/movie.gif)",
        completionCandidates = Candidates.files,
    )
    private val quiet by option("--quiet", help = "no progress").flag()

    override fun help(context: Context) = "Write the snapshots of a run as an animated GIF, MP4 or WebM."

    override fun run() {
        val target = out?.let { newFileOf(it, "--out") }
        checkOptions(target)
        val path = pathOf(directory, "dir")
        // What was changed beside the states does not show, but for the units; a notice says it.
        val input = AnalysisInput.ofRun(path, acceptLoss = true)
        val isThere = when (colour) {
            MovieColour.SPIN -> input.snapshot(input.size - 1).hasSpin
            MovieColour.MATERIAL -> input.snapshot(input.size - 1).hasMaterials
            else -> true
        }
        if (!isThere) {
            throw InputException(
                "--colour",
                null,
                "is ${colour.word}; it must be another: the spheres of $directory have none",
            )
        }
        if (input.state(input.size - 1).dimensions == 2) {
            val (option, value) = when {
                view == MovieView.SIDE -> "--view" to view.word
                colour == MovieColour.HEIGHT -> "--colour" to colour.word
                else -> null to ""
            }
            if (option != null) {
                throw InputException(option, null, "is $value; it must be another: $directory is of discs in a plane")
            }
        }
        for (notice in input.notices) warn(notice)
        val rate = fps ?: MovieOptions.rateFor(input.size)
        val file = target ?: path.resolve("plots").resolve("movie.gif")
        val movie = Movie(input, MovieOptions(view, colour, rate, width))
        val frames = writingLater(file.toAbsolutePath().parent) {
            try {
                movie.write(file, if (quiet) AnalysisProgress { _, _, _ -> } else ShownProgress())
            } catch (e: IllegalStateException) {
                throw RunException(e.message.orEmpty(), e)
            }
        }
        report(frames, rate, file)
    }

    private fun checkOptions(target: Path?) {
        fun wrong(option: String, value: Any, right: String): Nothing =
            throw InputException(option, null, "is $value; it must be $right")
        if (width !in MovieOptions.LEAST_WIDTH..MovieOptions.MOST_WIDTH) {
            wrong("--width", width, "in ${MovieOptions.LEAST_WIDTH}..${MovieOptions.MOST_WIDTH} pixels")
        }
        val format = if (target == null) MovieFormat.GIF else MovieFormat.of(target)
        if (format == null) wrong("--out", "$out", "a name that ends in .gif, .mp4 or .webm")
        if (!format.isAvailable) {
            wrong("--out", "$out", "a .gif or .mp4: for .webm the program ffmpeg must be on the PATH, with libvpx-vp9")
        }
        if (target != null && Files.isDirectory(target)) throw InputException("--out", null, "$out is a directory")
        val fps = fps ?: return
        if (fps !in MovieOptions.LEAST_RATE..format.mostFramesPerSecond) {
            wrong("--fps", fps, "in ${MovieOptions.LEAST_RATE}..${format.mostFramesPerSecond} for .${format.extension}")
        }
    }

    private fun report(frames: MovieFrames, rate: Double, file: Path) {
        frames.enlarged?.let { printLine("the box is drawn with its $it, and every frame says so") }
        val isOne = frames.number == 1
        if (isOne) printLine("the run has one snapshot only: for more, set output.snapshotEvery before a run")
        val count = if (isOne) "1 frame" else "${frames.number} frames"
        val length = String.format(
            Locale.ROOT,
            "%.${if (frames.number < rate) 2 else 1}f",
            frames.number / rate,
        ).removeSuffix(".0")
        val seconds = "$length s at ${number(rate)} per second"
        printLine("$count of ${frames.width} × ${frames.height} pixels, $seconds, ${size(Files.size(file))}, to $file")
        if (frames.writer ==
            "jcodec"
        ) {
            printLine("with the program ffmpeg, and libx264 in it, on the PATH it would be smaller")
        }
        if (fps == null &&
            rate < MovieOptions.USUAL_RATE
        ) {
            printLine("few frames are shown slowly; --fps sets another rate")
        }
    }

    private fun size(bytes: Long): String = String.format(Locale.ROOT, "%.1f MB", bytes / 1e6)
}
