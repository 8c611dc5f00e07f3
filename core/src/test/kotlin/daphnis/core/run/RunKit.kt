package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.scenario.OutputSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.descriptors.PrimitiveKind
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name

private const val TABLES = """{
    "name": "tables", "seed": 3,
    "box": { "lengths": [7, 7, 7] }, "boundary": { "type": "lees-edwards", "shearRate": 0.7 },
    "particles": { "count": 60, "sizes": { "type": "equal", "radius": 0.5 } },
    "velocities": { "type": "gaussian", "sigma": 1.0, "shearProfile": true },
    "restitution": { "type": "constant", "coefficient": 0.6 },
    "engine": { "name": "serial" },
    "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 1.2,
    "output": { "snapshotEvery": 4, "checkpointEvery": 3, "collisionLog": true, "transportEvery": 2 }
}"""

/**
 * A small run with every output there is: Lees–Edwards, 12 steps, a checkpoint every 3, a snapshot every 4. An output
 * that is off by default and not in the text is due every 2.
 */
internal fun tableScenario(vararg settings: String): Scenario {
    val others = PeriodicOutputs.all.filter { it.times(OutputSpec()).isNever && "\"${it.key}\"" !in TABLES }
    return ScenarioJson.parse(TABLES, "test", others.map { setting(it, 2) } + settings)
}

/** The setting by which [output] is due every [steps] steps, 0 for never; a log is due after each step or never. */
@OptIn(ExperimentalSerializationApi::class)
internal fun setting(output: PeriodicOutput, steps: Int): String {
    val keys = OutputSpec.serializer().descriptor
    val kind = keys.getElementDescriptor(keys.getElementIndex(output.key)).kind
    return "output.${output.key}=${if (kind == PrimitiveKind.BOOLEAN) "${steps > 0}" else "$steps"}"
}

/** The process is killed: nothing after it happens. */
internal class Killed : Error("killed")

/** Files of a process that is killed before operation [last], counted from 0. */
internal class MortalFiles(private val last: Int) : FileOperations() {
    val operations = ArrayList<String>()

    override fun begin(operation: String) {
        if (operations.size >= last) throw Killed()
        operations += operation
    }
}

internal fun startIn(
    directory: Path,
    scenario: Scenario = tableScenario(),
    force: Boolean = false,
    files: FileOperations = FileOperations(),
): Run = startRun(scenario, "test", RunDirectory(directory, files), force, Engines)

internal fun Run.toStep(step: Long): Summary = use { it.execute(cancelled = { it.simulation.step >= step }) }

/** Tables and states of a run by name, but for what says how long it took. */
internal fun results(directory: Path): Map<String, String> = buildMap {
    for (name in PeriodicOutputs.all.flatMap { it.files }) {
        val file = directory.resolve(name)
        if (Files.exists(file)) put(name, Files.readString(file))
    }
    val run = RunDirectory(directory)
    for (step in run.snapshotSteps()) put("snapshot $step", run.readSnapshot(step).let { f -> H5Sum.of(f) })
    put("digest", Summary.read(run.summary).stateDigest)
}

private object H5Sum {
    fun of(frame: daphnis.core.format.Snapshot): String =
        frame.population().let { daphnis.core.population.stateDigest(it) } +
            frame.image?.joinToString { it.contentHashCode().toString() }
}

/** Every file below [directory] but the lock, with its bytes. */
internal fun bytesIn(directory: Path): Map<String, List<Byte>> = Files.walk(directory).use { files ->
    files.filter { Files.isRegularFile(it) && it.name != ".lock" }.toList().associate {
        directory.relativize(it).toString() to
            Files.readAllBytes(it).asList()
    }
}

internal fun flip(file: Path, at: Int, bit: Int = 0) {
    val bytes = Files.readAllBytes(file)
    bytes[at] = (bytes[at].toInt() xor (1 shl bit)).toByte()
    Files.write(file, bytes)
}

internal fun cut(file: Path, length: Int) {
    Files.write(file, Files.readAllBytes(file).copyOf(length))
}

internal fun copyOf(directory: Path, target: Path): Path {
    Files.walk(directory).use { files ->
        for (file in files) {
            val copy = target.resolve(directory.relativize(file).toString())
            if (Files.isDirectory(file)) Files.createDirectories(copy) else Files.copy(file, copy)
        }
    }
    return target
}

/** Fails with [message] when asked to write. */
internal class FullFiles(private val from: Int, private val message: String) : FileOperations() {
    private var count = 0

    override fun begin(operation: String) {
        if (count++ >= from && !operation.startsWith("delete")) throw IOException(message)
    }
}
