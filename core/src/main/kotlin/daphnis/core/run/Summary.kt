package daphnis.core.run

import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import java.nio.file.Path

/**
 * `summary.json`, what a run came to. `docs/guide.md` explains every entry.
 *
 * @property finished false when the run was interrupted
 * @property maxOverlap deepest overlap at the end, as a fraction of the sum of two radii
 * @property energy kinetic energy at the end
 * @property momentum Σ m v along x, y, z at the end
 */
@Serializable
public class Summary(
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
) {
    /** Writes it to [path], atomically. */
    public fun write(path: Path) {
        val text = JSON.encodeToString(serializer(), this) + "\n"
        writeAtomically(path) { java.nio.file.Files.writeString(it, text) }
    }

    public companion object {
        private val JSON = Json {
            prettyPrint = true
            ignoreUnknownKeys = true
        }

        /** Reads what [write] wrote. */
        public fun read(path: Path): Summary = JSON.decodeFromString(serializer(), java.nio.file.Files.readString(path))
    }
}
