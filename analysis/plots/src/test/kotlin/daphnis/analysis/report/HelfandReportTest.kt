package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class HelfandReportTest {
    @TempDir
    lateinit var home: Path

    /** The row of η of a gas of 108 spheres at nσ³ = 1/2 with the [settings]; null where the report has none. */
    private fun viscosity(name: String, vararg settings: String, scenario: String = "elastic-gas"): NumberRow? {
        val gas = listOf(
            "particles={\"count\":108,\"sizes\":{\"type\":\"equal\",\"radius\":0.5},\"mass\":1}",
            "box.lengths=[6,6,6]",
            "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
            "timeStep={\"type\":\"fixed\",\"dt\":0.06}",
            "output={\"transportEvery\":1}",
            "until=12",
        )
        val path = home.resolve(name)
        Run.start(BuiltIn.scenario(scenario, gas + settings), scenario, path).use { it.execute() }
        val input = AnalysisInput.ofRun(path)
        val study = Study(input, 0.0, listOf(input.size - 1), AnalysisOptions(), path)
        return BoxNumbers(study).rows().find { it.key == "viscosity_helfand" }
    }

    @Test
    fun `an elastic gas at rest has its viscosity beside that of Enskog`() {
        val row = viscosity("equal", "until=45")!!
        assertEquals(0.5561, row.reference!!.value, 1e-4)
        assertTrue("Enskog" in row.reference.source)
        assertEquals(0.5561, row.value, 4 * row.error) { "${row.value} ± ${row.error}" }
        assertEquals("units of mass/(length time)", row.unit)
        assertTrue("lags from 1" in row.note) { row.note }
    }

    @Test
    fun `spheres of two sizes have it without a reference`() {
        val sizes = "particles={\"count\":108,\"sizes\":{\"type\":\"list\",\"radii\":[0.5,0.4]},\"mass\":1}"
        val row = viscosity("two", sizes)
        assertNotNull(row)
        assertNull(row!!.reference)
    }

    @Test
    fun `no other gas has it`() {
        val noise = "forces=[{\"type\":\"white-noise\",\"intensity\":0.1}]"
        val others = mapOf(
            "inelastic" to "restitution.coefficient=0.99",
            "rough" to "roughness={\"type\":\"constant\",\"coefficient\":1}",
            "walls" to "boundary={\"type\":\"walls\"}",
            "sheared" to "boundary={\"type\":\"lees-edwards\",\"shearRate\":0.01}",
            "forced" to noise,
            "growing" to "growth={\"rate\":0.0001}",
            "coarse" to "output={\"transportEvery\":2}",
        )
        for ((name, setting) in others) assertNull(viscosity(name, setting), name)
        val discs = viscosity("discs", "dimensions=2", "box.lengths=[15,15]")
        assertNull(discs)
        assertFalse(viscosity("again") == null)
    }
}
