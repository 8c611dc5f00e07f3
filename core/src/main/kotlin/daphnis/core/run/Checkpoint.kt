package daphnis.core.run

import daphnis.core.OutputState
import daphnis.core.population.Population
import kotlinx.serialization.json.Json
import java.io.DataOutputStream
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path

/**
 * Everything that a run needs to continue to the same bits, and to recognise its other files.
 *
 * The file: the eight bytes `DAPHNIS\n`, an int with the version of the format, then records, each a four-letter name,
 * a long with the length of what follows, that many bytes, and their CRC-32C as an int; all big-endian. `META` is JSON
 * ([CheckpointMeta]); `SCEN` is `scenario.json` as it was; `IDS `, `POSX` … `IMGZ` are arrays in the order of ids;
 * `OUTS`, only where there is any, is what outputs keep ([SavedOutputs]), except for the sums of `transport.csv`, which
 * are in `META`; `END.` is empty and last. A file that was cut short or has flipped bytes is refused. Format 2 has no
 * `SCEN`, and only the lengths of other files. In the run of a [Program] `SCEN` is `run.json`.
 *
 * @property scenario null in format 2
 */
internal class Checkpoint(
    val head: Head,
    val population: Population,
    private val own: Map<String, OutputState> = emptyMap(),
) {
    val meta: CheckpointMeta get() = head.meta
    val scenario: String? get() = head.scenario

    /** What outputs have saved, by name. */
    val outputs: Map<String, OutputState> get() = own + SavedOutputs.ofTransport(meta)

    /** Everything but the spheres. */
    class Head(val meta: CheckpointMeta, val scenario: String?)

    companion object {
        private const val OUTPUTS = "OUTS"
        private val IMAGES = listOf("IMGX", "IMGY", "IMGZ")
        private val json = Json { encodeDefaults = true }

        /** @param own what outputs have saved that has no place in [meta], by name */
        fun write(
            meta: CheckpointMeta,
            scenario: String,
            population: Population,
            own: Map<String, OutputState>,
            path: Path,
        ) {
            val order = population.indicesById()
            DataOutputStream(Files.newOutputStream(path).buffered(1 shl 16)).use { out ->
                val records = RecordWriter(out)
                records.text("META", json.encodeToString(CheckpointMeta.serializer(), meta))
                records.text("SCEN", scenario)
                val ids = ByteBuffer.allocate(4 * order.size)
                for (k in order) ids.putInt(population.id[k])
                records.write("IDS ", ids.array())
                for ((name, column) in columns(population)) {
                    val bytes = ByteBuffer.allocate(8 * order.size)
                    for (k in order) bytes.putDouble(column[k])
                    records.write(name, bytes.array())
                }
                for ((axis, name) in IMAGES.withIndex()) {
                    val bytes = ByteBuffer.allocate(4 * order.size)
                    for (k in order) bytes.putInt(population.boxesCrossed(population.id[k], axis))
                    records.write(name, bytes.array())
                }
                if (own.isNotEmpty()) records.write(OUTPUTS, SavedOutputs.bytes(own))
                records.write(Records.END, ByteArray(0))
            }
        }

        private fun columns(p: Population) = listOf(
            "POSX" to p.x, "POSY" to p.y, "POSZ" to p.z, "VELX" to p.vx, "VELY" to p.vy, "VELZ" to p.vz,
            "RADI" to p.radius, "MASS" to p.mass, "LAST" to p.lastCollision,
        )

        /** @throws CheckpointException with one line that says what is wrong with the file */
        fun read(path: Path): Checkpoint {
            val records = Records.read(path, Records.END)
            return decoded(path) {
                val own = if (OUTPUTS in records) SavedOutputs.of(records.bytes(OUTPUTS)) else emptyMap()
                Checkpoint(head(records), population(records), own)
            }
        }

        /** Reads what comes before the spheres. @throws CheckpointException as [read] does, as far as it reads */
        fun readHead(path: Path): Head {
            val records = Records.read(path, "IDS ")
            return decoded(path) { head(records) }
        }

        private fun <T> decoded(path: Path, decode: () -> T): T = try {
            decode()
        } catch (e: RuntimeException) {
            throw CheckpointException("$path: is damaged: ${e.message}")
        }

        private fun head(records: Records): Head {
            val text = records.text("META")
            if (records.version == Records.VERSION) {
                return Head(json.decodeFromString(CheckpointMeta.serializer(), text), records.text("SCEN"))
            }
            require("SCEN" !in records) { "it says format ${records.version} and has a record of another" }
            return Head(json.decodeFromString(CheckpointMeta2.serializer(), text).current(), null)
        }

        private fun population(records: Records): Population {
            val population = Population(
                records.doubles("POSX"), records.doubles("POSY"), records.doubles("POSZ"),
                records.doubles("VELX"), records.doubles("VELY"), records.doubles("VELZ"),
                records.doubles("RADI"), records.doubles("MASS"), records.integers("IDS "),
            )
            records.doubles("LAST").copyInto(population.lastCollision)
            for ((axis, name) in IMAGES.withIndex()) {
                records.integers(name).forEachIndexed { k, boxes ->
                    if (boxes != 0) {
                        population.addCrossing(k, axis, boxes)
                    }
                }
            }
            return population
        }
    }
}

/** Thrown when a checkpoint cannot be used; the message is one line that says why. */
internal class CheckpointException(message: String) : RuntimeException(message)
