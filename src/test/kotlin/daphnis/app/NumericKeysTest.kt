package daphnis.app

import daphnis.drills.scenarioSeeds
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.JsonUnquotedLiteral
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** Every number of every scenario, at values of all sizes: what `describe` accepts, a run can begin. */
class NumericKeysTest {
    @TempDir
    lateinit var folder: Path

    /** Of all keys and values one in [ONE_OF], others for other seeds; [ONE_OF] = 1 tries them all. */
    @Test
    fun `whatever number of a scenario is odd, it is refused with its key, or two steps can be made`() {
        val seen = HashSet<String>()
        val wrong = ArrayList<String>()
        var number = 0
        // What came later is last, so that the sample of the others is what it was.
        for (scenario in scenarioSeeds().sortedWith(compareBy({ "sources" in it }, { "dimensions" in it }))) {
            if (scenario.getValue("name") == JsonPrimitive("moons")) continue
            for (path in numbers(scenario).filter { seen.add("$it ${kind(scenario)}") }) {
                for (value in VALUES) {
                    if (number++ % ONE_OF != 0) continue
                    val text = put(scenario, path, value).toString()
                    tried(text)?.let { wrong += "${scenario["name"]} ${path.joinToString(".")} = $value: $it" }
                }
            }
        }
        assertEquals("", wrong.joinToString("\n"))
    }

    @Test
    fun `a force that no step can begin with is refused with its key`() {
        val hill = """frame={"type":"hill","angularSpeed":1,"verticalFactor":1e9}"""
        val ring =
            listOf(hill, """boundary={"type":"hill-sheet"}""", """timeStep={"type":"orbit-fraction","steps":100}""")
        for ((key, settings) in listOf(
            "frame.verticalFactor" to ring,
            "frame: cannot" to ring + "timeStep.steps=3" + "frame.verticalFactor=1",
            "forces[1]" to listOf(
                """timeStep={"type":"fixed","dt":0.01}""",
                """forces=[{"type":"uniform-acceleration","acceleration":[0,0,1]},""" +
                    """{"type":"uniform-acceleration","acceleration":[0,1e300,0]}]""",
            ),
        )) {
            val words = settings.flatMap { listOf("--set", it) }.toTypedArray()
            for (command in listOf("describe", "run")) {
                val out = if (command == "run") arrayOf("--out", "${folder.resolve("x")}") else emptyArray()
                assertRefused(daphnis(command, "cooling-gas", *words, *out), key, "in the first step")
            }
        }
    }

    /** What is wrong with what the commands say of a scenario. */
    private fun tried(text: String): String? {
        val file = Files.writeString(folder.resolve("s.json"), text)
        val described = daphnis("describe", "$file")
        if (described.code != 0) {
            val isLine = described.err.trimEnd().lines().size == 1 && "fault of daphnis" !in described.err
            return if (described.code == 2 && isLine) null else described.err
        }
        if ("Infinity" in described.out || "NaN" in described.out) return described.out
        // Steps of at most 1e-9 to the end of a scenario would be billions.
        val steps = when {
            "cell-crossing" in text -> arrayOf("--until", "1e-9")
            "timeStep" !in text -> emptyArray()
            else -> arrayOf("--steps", "2")
        }
        val run = daphnis("run", "$file", *steps, "--quiet", "--force", "--out", "${folder.resolve("out")}")
        return if (run.code == 0) null else run.err
    }

    private fun kind(scenario: JsonObject): List<Any?> = listOf("boundary", "frame", "particles", "velocities")
        .map { (scenario[it] as? JsonObject)?.get("type") ?: (scenario[it] as? JsonObject)?.keys }

    private fun numbers(tree: JsonElement, here: List<Any> = emptyList()): List<List<Any>> = when (tree) {
        is JsonObject -> tree.flatMap { (key, value) -> numbers(value, here + key) }
        is JsonArray -> tree.take(3).flatMapIndexed { k, value -> numbers(value, here + k) }
        is JsonPrimitive -> if (!tree.isString && tree.content.toDoubleOrNull() != null) listOf(here) else emptyList()
    }

    @OptIn(ExperimentalSerializationApi::class)
    private fun put(tree: JsonElement, path: List<Any>, value: String): JsonElement = when {
        path.isEmpty() -> JsonUnquotedLiteral(value)
        tree is JsonArray -> JsonArray(
            tree.mapIndexed { k, it ->
                if (k ==
                    path[0]
                ) {
                    put(it, path.drop(1), value)
                } else {
                    it
                }
            },
        )
        else -> JsonObject(
            (tree as JsonObject).mapValues { (key, it) ->
                if (key == path[0]) put(it, path.drop(1), value) else it
            },
        )
    }

    private companion object {
        const val ONE_OF = 101
        val VALUES = "0 -0.0 -1 1e300 -1e300 1e-300 -1e-300 1e9 1e40 1e-9 4.9e-324 1e155".split(" ")
    }
}
