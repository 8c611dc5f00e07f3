package daphnis.app.live

import daphnis.analysis.insitu.State
import daphnis.analysis.movie.MovieOptions
import daphnis.analysis.movie.StatePicture
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.plot.RunPlot
import daphnis.analysis.table.UnitNames
import daphnis.app.progress.Pace
import daphnis.app.progress.clock
import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.run.Run
import daphnis.core.scenario.FrameSetup
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Files
import java.util.Base64
import java.util.Locale
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/**
 * Shows [run] in [feed] while somebody looks: at most once a second, and so seldom that drawing takes a tenth of the
 * time at most. The thread of the run copies the state, another one draws. Whatever fails here is no failure of the
 * run: the page says it.
 */
internal class LiveOutput(private val run: Run, private val feed: Feed, private val newest: NewestState) : Output {
    private val pace = Pace(run.until)
    private val painter: ExecutorService = Executors.newSingleThreadExecutor {
        Thread(it, "daphnis-live-painter").apply {
            isDaemon = true
            priority = Thread.MIN_PRIORITY
        }
    }
    private val orbits = run.scenario?.let { FrameSetup.frequencies(it, it.name) }
    private val units = UnitNames(run.scenario?.units)
    private val picture = StatePicture(MovieOptions(width = WIDTH), units)
    private val scale = run.scenario?.let { PlotScale.of(it, run.simulation.population) }
    private val encoder = StateBytes(scale ?: PlotScale(units, null, 1.0))

    /** When the next picture may be begun; [BUSY] while one is made. Written by the painter when it has done one. */
    @Volatile
    private var due = System.nanoTime()
    private var isFirst = true
    private var isTold = false
    private var toldAt = 0L
    private var shownAt = 0.0
    private var collisionsBefore = 0L

    override fun open(simulation: Simulation, opening: Opening) {
        collisionsBefore = collisionsOf(simulation)
    }

    override fun write(simulation: Simulation) {
        val left = pace.left(simulation.time)
        if (!feed.isWatched) return
        val now = System.nanoTime()
        if (!isTold || now - toldAt >= LEAST_NANOSECONDS) tell(simulation, left, now)
        if (due != BUSY && now - due >= 0) show(simulation)
    }

    /** The state at which the run stands, for those who look; nothing is shown after it. The run has closed its files. */
    fun showLast() {
        if (feed.isWatched) {
            val simulation = run.simulation
            tell(simulation, pace.left(simulation.time), System.nanoTime())
            show(simulation)
        }
        painter.shutdown()
        painter.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS)
    }

    private fun tell(simulation: Simulation, left: Double, now: Long) {
        isTold = true
        toldAt = now
        feed.put(Feed.PROGRESS, progress(simulation, left))
    }

    private fun show(simulation: Simulation) {
        due = BUSY
        val begin = System.nanoTime()
        try {
            val state = State(
                simulation.population.copy(),
                simulation.boundary,
                simulation.time,
                orbits,
                run.scenario?.firstBody ?: Int.MAX_VALUE,
            )
            val walls = SeenWalls(simulation.boundary, run.scenario?.boundary, simulation.time)
            val step = simulation.step
            painter.execute { draw(state, walls, step, begin) }
        } catch (e: Exception) {
            problem(e)
        } catch (e: OutOfMemoryError) {
            problem(e)
        }
    }

    private fun progress(simulation: Simulation, left: Double): String {
        val seconds = pace.seconds()
        val collisions = collisionsOf(simulation)
        val rate = (collisions - collisionsBefore) / (seconds - shownAt)
        shownAt = seconds
        collisionsBefore = collisions
        val timeUnit = scale?.time ?: 1.0
        val timeName = scale?.timeName ?: units.time
        fun say(format: String, vararg values: Any) = String.format(Locale.ROOT, format, *values)
        val part = (simulation.time - simulation.runStart) / (run.until - simulation.runStart)
        val words = listOfNotNull(
            say("step %d", simulation.step),
            say("time %.4g of %.4g %s", simulation.time / timeUnit, run.until / timeUnit, UnitNames.raised(timeName)),
            "${clock(left)} left".takeIf { left.isFinite() },
            say("%.3g collisions/s", rate),
        )
        return "{\"part\": $part, \"text\": ${JsonPrimitive(words.joinToString(" · "))}}"
    }

    private fun collisionsOf(simulation: Simulation): Long = simulation.collisions?.counters?.collisions ?: 0

    /** On the painter's thread; [begin] is when the copy was begun, which counts too. */
    private fun draw(state: State, walls: SeenWalls, step: Long, begin: Long) {
        try {
            if (feed.wants(Feed.STATE)) {
                newest.put(step, encoder.of(state, walls, step))
                feed.put(Feed.STATE, "{\"number\": $step}")
            }
            if (feed.wants(Feed.PICTURE)) feed.put(Feed.PICTURE, "data:image/png;base64," + base64(picture.png(state)))
            val series = run.directory.series
            if (run.hasSeries && scale != null && Files.exists(series)) {
                val plot = RunPlot.svg(series, run.scenario?.name.orEmpty(), scale)
                if (plot != null) feed.put(Feed.SERIES, "data:image/svg+xml;base64," + base64(plot.toByteArray()))
            }
            val end = System.nanoTime()
            // The first takes far longer than another, for all that Java loads.
            due = maxOf(begin + LEAST_NANOSECONDS, if (isFirst) end else end + SHARE * (end - begin))
            isFirst = false
        } catch (e: Exception) {
            problem(e)
        } catch (e: OutOfMemoryError) {
            problem(e)
        } catch (e: LinkageError) {
            // Java without a part of its drawing.
            problem(e)
        }
    }

    /** Pictures end, and the run goes on. */
    private fun problem(e: Throwable) {
        feed.put(Feed.PROBLEM, "no more pictures: ${inWords(e)}; that is no fault of the run")
    }

    private fun base64(bytes: ByteArray) = Base64.getEncoder().encodeToString(bytes)

    private companion object {
        const val WIDTH = 900
        const val BUSY = Long.MAX_VALUE
        const val LEAST_NANOSECONDS = 1_000_000_000L
        const val SHARE = 9
        const val PATIENCE_SECONDS = 5L
    }
}
