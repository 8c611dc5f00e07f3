package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class HelfandReportTest {
    @TempDir
    lateinit var home: Path

    /** The rows of coefficients of a gas of 108 spheres at nσ³ = 1/2 with the [settings], by key. */
    private fun coefficients(name: String, vararg settings: String): Map<String, NumberRow> {
        val gas = listOf(
            "particles={\"count\":108,\"sizes\":{\"type\":\"equal\",\"radius\":0.5},\"mass\":1}",
            "box.lengths=[6,6,6]",
            "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
            "timeStep={\"type\":\"fixed\",\"dt\":0.06}",
            "output={\"transportEvery\":1}",
            "until=12",
        )
        val path = home.resolve(name)
        Run.start(BuiltIn.scenario("elastic-gas", gas + settings), "elastic-gas", path).use { it.execute() }
        val input = AnalysisInput.ofRun(path)
        val study = Study(input, 0.0, listOf(input.size - 1), AnalysisOptions(), path)
        return BoxNumbers(study).rows().filter { it.key!!.endsWith("_helfand") }.associateBy { it.key!! }
    }

    @Test
    fun `an elastic gas at rest has its coefficients beside those of Enskog`() {
        val rows = coefficients("equal", "until=45")
        val enskog =
            mapOf("viscosity_helfand" to 0.5561, "bulk_viscosity_helfand" to 0.4255, "conductivity_helfand" to 2.3817)
        assertEquals(enskog.keys, rows.keys)
        for ((key, expected) in enskog) {
            val row = rows.getValue(key)
            assertEquals(expected, row.reference!!.value, 2e-4 * expected) { key }
            assertTrue("Enskog" in row.reference.source)
            assertEquals(expected, row.value, 4 * row.error) { "$key ${row.value} ± ${row.error}" }
            assertTrue("lags from 1" in row.note) { row.note }
        }
        assertEquals("units of mass/(length time)", rows.getValue("bulk_viscosity_helfand").unit)
        assertEquals("units of 1/(length time)", rows.getValue("conductivity_helfand").unit)
    }

    @Test
    fun `spheres of two sizes have viscosities without a reference, and no conductivity`() {
        val sizes = "particles={\"count\":108,\"sizes\":{\"type\":\"list\",\"radii\":[0.5,0.4]},\"mass\":1}"
        val rows = coefficients("two", sizes)
        assertEquals(setOf("viscosity_helfand", "bulk_viscosity_helfand"), rows.keys)
        for (row in rows.values) assertNull(row.reference)
    }

    @Tag("thorough")
    @Test
    fun `no other gas has any`() {
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
        for ((name, setting) in others) assertEquals(emptyMap<String, NumberRow>(), coefficients(name, setting), name)
        assertEquals(emptyMap<String, NumberRow>(), coefficients("discs", "dimensions=2", "box.lengths=[15,15]"))
        assertEquals(3, coefficients("again").size)
    }
}
