package daphnis.drills

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.relativeTo

/**
 * Compares run directories file by file, byte by byte; what may differ between runs of the same scenario is left out.
 */
internal object RunFiles {
    /**
     * Of the summary: who did it, when and how fast. `redoneSteps` and `causalityReplays` say how an engine went about
     * it.
     */
    private val TOLD =
        setOf("engine", "threads", "wallSeconds", "stepsPerSecond", "jvm", "redoneSteps", "causalityReplays")

    /** What differs between [expected] and [actual], nothing when they are the same run. */
    fun differences(expected: Path, actual: Path): List<String> {
        val left = files(expected)
        val right = files(actual)
        val missing = (left.keys - right.keys).map { "$it is missing" }
        val extra = (right.keys - left.keys).map { "$it should not be there" }
        return missing + extra +
            (left.keys intersect right.keys).sorted().filterNot {
                same(left.getValue(it), right.getValue(it))
            }.map { "$it differs" }
    }

    private fun files(directory: Path): Map<String, Path> = Files.walk(directory).use { paths ->
        paths.filter { it.isRegularFile() }.toList().associateBy { it.relativeTo(directory).toString() }
    }.filterKeys { !it.startsWith("plots/") && !it.startsWith("checkpoint") && it != ".lock" }

    private fun same(a: Path, b: Path): Boolean = when (a.name) {
        "summary.json" -> json(a) - TOLD == json(b) - TOLD
        "scenario.json" -> json(a) - "engine" == json(b) - "engine"
        else -> a.readBytes().contentEquals(b.readBytes())
    }

    private fun json(path: Path): JsonObject = Json.parseToJsonElement(Files.readString(path)).jsonObject

    private operator fun JsonObject.minus(keys: Set<String>) = filterKeys { it !in keys }

    private operator fun JsonObject.minus(key: String) = filterKeys { it != key }
}
