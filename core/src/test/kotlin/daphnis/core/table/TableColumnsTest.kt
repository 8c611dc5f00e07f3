package daphnis.core.table

import daphnis.core.run.ModeColumns
import daphnis.core.run.PeriodicOutputs
import daphnis.core.run.Run
import daphnis.core.run.SeriesColumns
import daphnis.core.run.TransportColumns
import daphnis.core.run.tableScenario
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** Files have the columns that are declared. */
class TableColumnsTest {
    @TempDir
    lateinit var home: Path

    private val tables = PeriodicOutputs.all.flatMap { it.tables }

    @Test
    fun `the files of a run have the declared columns and as many numbers in every row`() {
        // Rough spheres with edges between walls of which one moves and one is a piston have all columns that there are,
        // but for those of spheres that grow, which are smooth, of elastic gases at rest, and of other pistons.
        val ofGrowth = setOf(SeriesColumns.FILLING_FACTOR, SeriesColumns.REDUCED_PRESSURE)
        val ofHeat = TransportColumns.KINETIC_HEAT + TransportColumns.COLLISIONAL_HEAT
        val ofOthers = SeriesColumns.PISTON_POSITION.dropLast(1) + SeriesColumns.PISTON_SPEED.dropLast(1)
        val body = "bodies=[{\"radius\": 0.6, \"position\": [0, 0, 0]}]"
        val floor = """"lowerZ": { "motion": { "type": "sine", "amplitude": 0.1, "frequency": 1 } }"""
        val roof = """"upperZ": { "motion": { "type": "piston", "mass": 1e6 } }"""
        val plane = """{ "type": "plane", "point": [0, 0, 99], "normal": [0, 0, -1] }"""
        val planes = """"surfaces": [${List(8) { plane }.joinToString()}]"""
        val walls = """boundary={ "type": "walls", "axes": "z", "faces": { $floor, $roof }, $planes }"""
        val edges = """interaction={ "type": "square-shoulder", "ratio": 1.1, "height": 0.01 }"""
        val rough = """roughness={"type": "smooth"}"""
        val scenario = tableScenario(rough, body, walls, edges, "velocities.shearProfile=false")
        Run.start(scenario, "test", home.resolve("run")).use { it.execute() }
        for (table in tables) {
            val lines = Files.readAllLines(home.resolve("run").resolve(table.file)).map { it.split(',') }
            val columns = table.columns - ofGrowth - ofHeat - ofOthers.toSet()
            assertEquals(columns.map { it.name }, lines[0].map { UnitsOfDimensions.nameIn(it) })
            assertTrue(lines.size > 2) { table.file }
            for (line in lines.drop(1)) {
                assertEquals(columns.size, line.size) { table.file }
                for (cell in line) cell.toDouble()
            }
        }
    }

    @Test
    fun `what readers cannot do without is what they needed before columns were declared`() {
        assertEquals(listOf("time", "particles", "collisions"), SeriesColumns.needed)
        assertEquals(
            "time particles mass c_xx c_yy c_zz c_xy scale_height collisions dissipated virial_xy",
            TransportColumns.needed.joinToString(" "),
        )
        assertEquals(ModeColumns.columns.map { it.name } - "step", ModeColumns.needed)
    }
}
