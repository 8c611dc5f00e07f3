package daphnis.analysis.transport

import daphnis.analysis.series.SeriesTable
import daphnis.core.format.FormatException
import daphnis.core.run.CollisionColumns
import daphnis.core.run.CollisionColumns.COEFFICIENT
import daphnis.core.run.CollisionColumns.IMPACT_SPEED
import daphnis.core.run.CollisionColumns.IMPULSE
import daphnis.core.run.CollisionColumns.SEPARATION
import daphnis.core.run.CollisionColumns.SURFACE_DISSIPATION
import daphnis.core.run.CollisionColumns.TANGENTIAL_IMPULSE
import daphnis.core.run.Run
import daphnis.core.run.SeriesColumns
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs

class CollisionTableTest {
    @TempDir
    lateinit var home: Path

    private fun run(vararg settings: String): Path {
        val small = listOf("particles.count=200", "box.lengths=[10,10,10]", "until=4", "output.collisionLog=true")
        val scenario = BuiltIn.scenario("rough-gas", small + settings)
        Run.start(scenario, "test", home.resolve("run")).use { it.execute() }
        return home.resolve("run")
    }

    @Test
    fun `rows of rough spheres account for the energy that a run loses, surfaces apart`() {
        val run = run()
        val table = CollisionTable.read(run.resolve("collisions.csv"))
        val series = SeriesTable.read(run.resolve("series.csv"))
        assertTrue(table.isRough)
        assertEquals(series[SeriesColumns.COLLISIONS].last(), table.size.toDouble())
        assertTrue(table.size > 300)
        val energy = series[SeriesColumns.TOTAL_ENERGY]
        val restitution = (0 until table.size).sumOf {
            0.5 * table[IMPULSE][it] * (1 - table[COEFFICIENT][it]) * table[IMPACT_SPEED][it]
        }
        val surfaces = table[SURFACE_DISSIPATION].sum()
        assertTrue(restitution > 10 && surfaces > 10)
        assertEquals(energy.first() - energy.last(), restitution + surfaces, 1e-11 * energy.first())
        for (k in 0 until table.size) {
            val along = (0..2).sumOf { table[TANGENTIAL_IMPULSE[it]][k] * table[SEPARATION[it]][k] }
            assertTrue(abs(along) < 1e-13) { "row $k: $along" }
        }
        assertTrue((0..2).all { axis -> table[TANGENTIAL_IMPULSE[axis]].any { it > 0.1 } })
    }

    @Test
    fun `the file of smooth spheres has the columns that it always had`() {
        val file = run("roughness=null", "spins=null").resolve("collisions.csv")
        assertEquals(HEAD, Files.readAllLines(file)[0])
        val table = CollisionTable.read(file)
        assertTrue(table.size > 300)
        assertFalse(table.isRough)
        assertEquals(-1.0, table[IMPULSE].zip(table[IMPACT_SPEED]) { i, v -> -i / v / 0.95 }.average(), 1e-12)
    }

    @Test
    fun `a row that is damaged is named with its line, and one that is being written is left out`() {
        val head = CollisionColumns.columns.take(10).joinToString(",")
        fun read(vararg rows: String) =
            Files.writeString(home.resolve("collisions.csv"), "$head\n" + rows.joinToString("\n"))
                .let { CollisionTable.read(it) }
        val row = "7,0.5,0,3,1.5,0.9,1.4,0.5,0.5,0.7"
        assertEquals(2, read(row, row, "8,0.1,").size)
        val e = assertThrows(FormatException::class.java) { read(row, "6" + row.drop(1), "") }
        assertTrue("collisions.csv:3: step is '6.0'; it must be at least that of the row before, 7.0" in e.message!!)
        val missing = home.resolve("other.csv").also { Files.writeString(it, "step,id_lower\n1,2\n") }
        val f = assertThrows(FormatException::class.java) { CollisionTable.read(missing) }
        assertTrue("column 'time_in_step' is missing" in f.message!!) { f.message }
    }

    private companion object {
        const val HEAD = "step,time_in_step [units of time],id_lower,id_higher,impact_speed [units of length/time]," +
            "coefficient,impulse [units of mass length/time],separation_x [units of length]," +
            "separation_y [units of length]," +
            "separation_z [units of length]"
    }
}
