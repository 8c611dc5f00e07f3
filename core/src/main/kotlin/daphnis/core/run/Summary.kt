package daphnis.core.run

import daphnis.core.collision.CollisionCounters
import daphnis.core.format.FormatException
import daphnis.core.format.PackedFile
import daphnis.core.format.reasonOf
import daphnis.core.population.stateDigest
import daphnis.core.scenario.PlacementSpec
import daphnis.core.search.Overlap
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * `summary.json`, the result of a run. `docs/runs.md` explains every entry.
 *
 * @property finished false when the run was interrupted
 * @property maxOverlap deepest overlap at the end, as a fraction of the sum of two radii
 * @property energy kinetic energy at the end
 * @property momentum Σ m v along x, y, z at the end
 * @property edgeEvents passages and reflections at edges of interactions, which are no collisions
 * @property mergers collisions in which two spheres became one
 * @property broken spheres that broke into pieces
 * @property swapAttempts pairs of unlike spheres that were drawn to swap their places
 * @property swaps those of them that had room to
 * @property from the state of another run from which it started; null when it did not
 */
@OptIn(ExperimentalSerializationApi::class)
@Serializable
public class Summary @JvmOverloads constructor(
    public val stateDigest: String,
    public val finished: Boolean,
    public val scenario: String,
    public val particles: Int,
    public val steps: Long,
    public val time: Double,
    public val collisions: Long,
    public val wallCollisions: Long,
    public val engine: String,
    public val threads: Int,
    public val wallSeconds: Double,
    public val stepsPerSecond: Double,
    public val maxOverlap: Double,
    public val guardActivations: Long,
    public val redoneSteps: Long,
    public val causalityReplays: Long,
    public val energy: Double,
    public val temperature: Double,
    public val momentum: List<Double>,
    public val version: String,
    public val jvm: String,
    public val from: String? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val edgeEvents: Long = 0,
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val mergers: Long = 0,
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val broken: Long = 0,
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val swapAttempts: Long = 0,
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val swaps: Long = 0,
) {
    internal fun bytes(): ByteArray = (JSON.encodeToString(serializer(), this) + "\n").toByteArray(Charsets.UTF_8)

    /** Writes the summary into [directory], atomically. */
    internal fun write(directory: RunDirectory) {
        directory.files.writeAtomically(directory.summary) { Files.write(it, bytes()) }
    }

    public companion object {
        private val JSON = Json {
            prettyPrint = true
            ignoreUnknownKeys = true
        }

        /**
         * Reads the `summary.json` of a run.
         *
         * @throws FormatException when it cannot be read or is not a summary
         */
        @JvmStatic
        public fun read(path: Path): Summary = try {
            JSON.decodeFromString(serializer(), PackedFile.text(path))
        } catch (e: CharacterCodingException) {
            throw FormatException("$path: is not UTF-8 text")
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
        } catch (e: IllegalArgumentException) {
            throw FormatException("$path: is not a summary of daphnis: ${e.message.orEmpty().lineSequence().first()}")
        }

        internal fun of(plan: RunPlan, finished: Boolean, seconds: Double): Summary {
            val simulation = plan.simulation
            val population = simulation.population
            val sums = plan.sums.take(simulation)
            val c = simulation.collisions?.counters ?: CollisionCounters()
            val engine = simulation.workforce
            return Summary(
                stateDigest = stateDigest(population),
                finished = finished,
                scenario = plan.name,
                particles = population.size,
                steps = simulation.step,
                time = simulation.time,
                collisions = c.collisions,
                wallCollisions = c.wallCollisions,
                engine = engine?.name ?: "none",
                threads = engine?.threads ?: 1,
                wallSeconds = seconds,
                stepsPerSecond = if (seconds > 0) simulation.step / seconds else 0.0,
                maxOverlap = Overlap.deepest(
                    population,
                    simulation.boundary,
                    simulation.time,
                    minOf(engine?.threads ?: 1, Runtime.getRuntime().availableProcessors()),
                ).depth,
                guardActivations = c.guardActivations,
                redoneSteps = c.redoneSteps,
                causalityReplays = c.causalityReplays,
                energy = sums.kineticEnergy,
                temperature = sums.granularTemperature,
                momentum = List(3) { sums.momentum(it) },
                version = Version.text,
                jvm = "${System.getProperty("java.vm.name")} ${System.getProperty("java.runtime.version")}",
                from = plan.scenario?.placement?.file?.origin,
                edgeEvents = c.edgeEvents,
                mergers = c.mergers,
                broken = c.broken,
                swapAttempts = c.swapAttempts,
                swaps = c.swaps,
            )
        }
    }
}
