package daphnis.core.run

import daphnis.core.OutputState
import daphnis.core.population.Bonds
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereQuantity
import kotlinx.serialization.json.Json
import java.io.DataOutputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * Everything that a run needs to continue to the same bits, and to recognise its other files.
 *
 * The file, of format 4: the eight bytes `DAPHNIS\n`, an int with the version of the format, then records, each a
 * four-letter name, a long with the length of what follows, that many bytes, and their CRC-32C as an int; all
 * big-endian. `META` is JSON ([CheckpointMeta]); `SCEN` is `scenario.json` as it was; `IDS `, `POSX` … `IMGZ` are
 * arrays in the order of ids; `OUTS` is what outputs keep ([SavedOutputs]); `END.` is empty and last. Only
 * spheres with spins have `SPNX` … `SPNZ`, only those with materials `MATE`, and their names, a line each, in `NAME`; and
 * only those whose pairs have states `PAIR`: lower id, higher id and state of each pair ([Bonds]). A
 * file that was cut short, lacks a record or has flipped bytes is refused. In the run of a [Program] `SCEN` is
 * `run.json`. Formats 2 and 3 are read, see [OlderMeta].
 *
 * @property outputs what outputs have saved, by name
 */
internal class Checkpoint(val head: Head, val population: Population, val outputs: Map<String, OutputState>) {
    val meta: CheckpointMeta get() = head.meta
    val scenario: String? get() = head.scenario

    /**
     * What comes before the spheres.
     *
     * @property scenario null in format 2
     * @property saved what an output keeps in `META` of formats 2 and 3
     */
    class Head(val meta: CheckpointMeta, val scenario: String?, val saved: Map<String, OutputState> = emptyMap())

    companion object {
        private const val META = "META"
        private const val SCENARIO = "SCEN"
        private const val IDS = "IDS "
        private const val OUTPUTS = "OUTS"
        private const val MATERIALS = "NAME"
        private const val PAIRS = "PAIR"
        private val COLUMNS = SphereQuantity.entries.flatMap { it.records }
        private val IMAGES = listOf("IMGX", "IMGY", "IMGZ")
        private val NAMES = setOf(META, SCENARIO, IDS, OUTPUTS, MATERIALS, PAIRS, Records.END) + COLUMNS + IMAGES
        private val json = Json { encodeDefaults = true }

        /** @param outputs what they have saved, by name */
        fun write(
            meta: CheckpointMeta,
            scenario: String,
            spheres: SpheresById,
            outputs: Map<String, OutputState>,
            path: Path,
        ) {
            DataOutputStream(Files.newOutputStream(path).buffered(1 shl 16)).use { out ->
                val records = RecordWriter(out)
                records.text(META, json.encodeToString(CheckpointMeta.FILED, meta))
                records.text(SCENARIO, scenario)
                records.integers(IDS, spheres.ids)
                for ((place, column) in spheres.columns) records.doubles(COLUMNS[place], column)
                if (spheres.materials.isNotEmpty()) records.text(MATERIALS, spheres.materials.joinToString("\n"))
                if (spheres.havePairs) records.integers(PAIRS, spheres.pairs)
                for ((name, boxes) in IMAGES.zip(spheres.boxes)) records.integers(name, boxes)
                records.write(OUTPUTS, SavedOutputs.bytes(outputs))
                records.write(Records.END, ByteArray(0))
            }
        }

        /** @throws CheckpointException with one line that says what is wrong with the file */
        fun read(path: Path): Checkpoint {
            val records = Records.read(path, Records.END)
            return decoded(path) {
                records.requireOnly(NAMES)
                val head = head(records)
                Checkpoint(head, population(records), head.saved + outputs(records))
            }
        }

        /** Reads what comes before the spheres. @throws CheckpointException as [read] does, as far as it reads */
        fun readHead(path: Path): Head {
            val records = Records.read(path, IDS)
            return decoded(path) { head(records) }
        }

        private fun <T> decoded(path: Path, decode: () -> T): T = try {
            decode()
        } catch (e: RuntimeException) {
            throw CheckpointException("$path: is damaged: ${e.message}")
        }

        private fun head(records: Records): Head {
            val text = records.text(META)
            if (records.version == Records.VERSION) {
                return Head(json.decodeFromString(CheckpointMeta.FILED, text), records.text(SCENARIO))
            }
            val older = json.decodeFromString(OlderMeta.FILED, text)
            if (records.version > Records.OLDEST) return Head(older.current(), records.text(SCENARIO), older.saved())
            require(SCENARIO !in records) { "it says format ${records.version} and has a record of another" }
            return Head(older.current(), null, older.saved())
        }

        /** A record that is not there would let sums begin anew without a word, so only older formats may lack it. */
        private fun outputs(records: Records): Map<String, OutputState> {
            val isComplete = OUTPUTS in records || records.version == Records.VERSION
            return if (isComplete) SavedOutputs.of(records.bytes(OUTPUTS)) else emptyMap()
        }

        private fun population(records: Records): Population {
            val optional = SphereQuantity.entries.sumOf { quantity ->
                if (quantity.records.any { it in records }) quantity.bit else 0
            }
            val columns = Array(COLUMNS.size) { SphereQuantity.NONE }
            for (place in SphereQuantity.present(optional)) columns[place] = records.doubles(COLUMNS[place])
            val names = if (MATERIALS in records) records.text(MATERIALS).split('\n') else emptyList()
            val ids = records.integers(IDS)
            val bonds = if (PAIRS in records) Bonds.column(ids, records.integers(PAIRS)) else Bonds.NONE
            val population = Population(PopulationColumns(columns, ids, bonds), names)
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
