package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.Opening
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.engine.CollisionForcing
import daphnis.core.input.InputException
import daphnis.core.population.PopulationSums
import daphnis.core.populationOf
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.OutputSpec
import daphnis.core.surface.ConstantRestitution
import daphnis.core.table.Dimension
import daphnis.core.table.UnitsOfDimensions
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption

class RunOutputsTest {
    @TempDir
    lateinit var home: Path

    private fun run(scenario: String, name: String, vararg settings: String): Summary =
        Run.start(BuiltIn.scenario(scenario, settings.asList()), scenario, home.resolve(name)).use { it.execute() }

    private fun table(file: String): Map<String, List<String>> {
        val lines = Files.readAllLines(home.resolve(file)).map { it.split(',') }
        for (line in lines) assertEquals(lines[0].size, line.size)
        return lines[0].withIndex().associate { (k, head) ->
            UnitsOfDimensions.nameIn(head) to lines.drop(1).map { it[k] }
        }
    }

    @Test
    fun `every column of a quantity has its unit in its head, as the scenario says`() {
        val tables = arrayOf("transportEvery", "modesEvery", "bodiesEvery").map { "output.$it=1" }.toTypedArray()
        run("ring-patch", "ring", *tables, "output.collisionLog=true", "untilOrbits=0.02")
        fun head(file: String) = Files.readAllLines(home.resolve("ring/$file"))[0]
        assertTrue(head("series.csv").startsWith("step,time [s],particles,collisions,kinetic_energy [J],")) {
            head("series.csv")
        }
        assertEquals("speed_from [m/s],speed_to [m/s],collisions", head("impacts.csv"))
        assertTrue("time_in_step [s],id_lower,id_higher,impact_speed [m/s],coefficient," in head("collisions.csv")) {
            head("collisions.csv")
        }
        for (columns in PeriodicOutputs.all.flatMap { it.tables }) {
            val names = head(columns.file).split(',')
            for ((column, name) in columns.columns.zip(names)) {
                assertEquals(column.dimension != Dimension.NUMBER, name.startsWith("${column.name} [")) { name }
            }
        }
    }

    @Test
    fun `only rough spheres have all nine components of what collisions carry`() {
        run("rough-ring", "rough", "output.transportEvery=1", "untilOrbits=0.2", "box.lengths=[40,40,20]")
        run("ring-patch", "smooth", "output.transportEvery=1", "untilOrbits=0.02", "box.lengths=[40,40,20]")
        val rough = table("rough/transport.csv")
        // The spheres are at rest at first: surfaces turn them backwards, and what carries momentum turns the other way.
        val turned = rough.getValue("virial_yx").last().toDouble() - rough.getValue("virial_xy").last().toDouble()
        val spins = table("rough/series.csv").getValue("mean_spin_z").last().toDouble()
        assertTrue(turned != 0.0 && spins < 0) { "$turned $spins" }
        val inertia = 0.4 * 1.4826 * 1.4826 * rough.getValue("mass").last().toDouble()
        assertEquals(-inertia * spins, turned, 1e-9 * Math.abs(turned))
        val smooth = table("smooth/transport.csv").keys
        assertEquals(rough.keys - setOf("virial_yx", "virial_zx", "virial_zy"), smooth)
    }

    @Test
    fun `series, transport and summary of the paper's box have one granular temperature`() {
        val summary =
            run(
                "paper-figure-1",
                "paper",
                "particles.count=3000",
                "until=2",
                "output.transportEvery=5",
                "output.seriesEvery=5",
            )
        val series = table("paper/series.csv")
        val transport = table("paper/transport.csv")
        fun trace(name: String, row: Int) =
            listOf("xx", "yy", "zz").sumOf { transport.getValue("${name}_$it")[row].toDouble() } / 3
        val temperatures = series.getValue("granular_temperature").map { it.toDouble() }
        for (row in temperatures.indices) assertEquals(temperatures[row], trace("c", row), 1e-14 * temperatures[row])
        assertEquals(temperatures.last(), summary.temperature)
        // Components uniform in ±0.05, no flow yet; the box of two wants a flow of rate 0.05.
        val start = 0.05 * 0.05 / 3
        assertEquals(start, temperatures[0], 0.03 * start)
        assertEquals(start + 0.05 * 0.05 * 4 / 12 / 3, trace("kinetic", 0), 0.03 * start)
    }

    @Test
    fun `energies stand in the series where they mean something`() {
        run("cooling-gas", "gas", "particles.count=100", "until=0.2")
        val gas = table("gas/series.csv")
        assertEquals(gas["kinetic_energy"], gas["total_energy"])
        assertTrue(gas.getValue("kinetic_energy").size > 1) { "the table is empty" }
        assertTrue(
            gas.getValue("potential_energy").all { it == "0.0" } && gas.getValue("hill_energy").all { it == "NaN" },
        )
        run("self-gravity-wakes", "ring", "box.lengths=[60,60,8]", "untilOrbits=0.02")
        val ring = table("ring/series.csv")
        assertTrue(ring.getValue("total_energy").size > 1) { "the table is empty" }
        assertTrue(ring.getValue("total_energy").all { it == "NaN" })
        assertTrue(ring.getValue("potential_energy").all { it.toDouble() < 0 })
        assertTrue(ring.getValue("hill_energy").all { it.toDouble().isFinite() })
        run(
            "cooling-gas",
            "falling",
            "particles.count=100",
            "until=0.2",
            "forces=[{\"type\":\"uniform-acceleration\",\"acceleration\":[0,0,-1]}]",
        )
        val falling = table("falling/series.csv")
        assertTrue(falling.getValue("total_energy").size > 1) { "the table is empty" }
        assertTrue(
            falling.getValue("potential_energy").all { it == "NaN" } &&
                falling.getValue("total_energy").all { it == "NaN" },
        ) { "it falls through its faces" }
    }

    @Test
    fun `rows reach the disk within a second of the run, not with the checkpoint`() {
        var now = 0L
        val directory = RunDirectory(home.resolve("live")).also { Files.createDirectories(it.snapshots) }
        val p = populationOf(Sphere(x = -2.0, vx = 1.0), Sphere(x = 2.0, vx = -1.0))
        val s =
            Simulation(
                p,
                Walls(Box.centred(8.0, 8.0, 8.0)),
                CollisionForcing(ConstantRestitution(1.0), recordCollisions = true),
                FixedTimeStep(0.5),
            )
        val spec = OutputSpec(seriesEvery = 1, transportEvery = 1, collisionLog = true)
        val files = listOf(directory.series, directory.transport, directory.collisions)
        RunFiles(directory, clock = { now }).use { tables ->
            val usual = PeriodicOutputs.make(spec, StepSums(PopulationSums(null)), tables)
            val outputs = RunOutputs(usual, Output { tables.flushIfDue() })
            outputs.open(s, Opening.START)
            fun step(nanoseconds: Long) {
                now += nanoseconds
                s.advance()
                outputs.write(s)
            }
            outputs.write(s)
            step(999_999_999)
            assertTrue(files.all { Files.size(it) == 0L }) { "not at every row" }
            step(1)
            assertEquals(
                listOf(4, 4),
                listOf(directory.series, directory.transport).map {
                    Files.readAllLines(it).size
                },
            )
            repeat(3) { step(1) }
            assertEquals(4, Files.readAllLines(directory.series).size)
            step(1_000_000_000)
            assertEquals(8, Files.readAllLines(directory.series).size)
            assertTrue(s.collisions!!.counters.collisions > 0 && Files.readAllLines(directory.collisions).size > 1)
            assertTrue(files.all { Files.readString(it).endsWith("\n") }) { "whole lines" }
        }
    }

    @Test
    fun `a table that another version began is not gone on with`(@TempDir path: Path) {
        val directory = RunDirectory(path)
        RunFiles(directory).use { files ->
            files.table(SeriesColumns.rows)
            files.flush()
        }
        val file = path.resolve("series.csv")
        val old = Files.readString(file).replaceFirst("kinetic_energy", "energy_of_motion")
        for (head in listOf(Files.readString(file), old)) {
            Files.writeString(file, head)
            val beginnings = mapOf("series.csv" to Beginning.of(file, Files.size(file)))
            Files.write(file, byteArrayOf(-1, -64), StandardOpenOption.APPEND) // no characters, behind what is known
            RunFiles(directory, beginnings).use { files ->
                if (head != old) {
                    files.table(SeriesColumns.rows)
                } else {
                    val e = assertThrows(InputException::class.java) { files.table(SeriesColumns.rows) }
                    assertTrue("has other columns than this version of daphnis writes" in e.message!!)
                }
            }
        }
        assertEquals(old, Files.readString(file, Charsets.ISO_8859_1).dropLast(2))
    }
}
