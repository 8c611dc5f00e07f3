package daphnis.core.physics

import daphnis.core.GeneratedPage
import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.nio.file.Files

/**
 * The page of validation is what the record of measured numbers says. Where it is written anew, what the physics in full
 * has measured last in this folder is put into the record first.
 */
@Tag("jdk-neutral")
class ValidationPageTest {
    @Test
    fun `the page has the numbers of the record`() {
        val file = Repository.root.resolve(ValidationRecord.PATH)
        var record = ValidationRecord.read()
        if (System.getProperty("daphnis.reference") == "write" && Files.exists(FULL_TABLE)) {
            record = record.with(Files.readAllLines(FULL_TABLE))
            Files.writeString(file, record.json())
        }
        assertEquals(record.json(), Files.readString(file)) { "a line for each row, as this program writes it" }
        assertTrue(record.groups.flatMap { it.rows }.all { it.ok in setOf("ok", "no", "") })
        GeneratedPage("docs/reference/validation.md", "Measured numbers", "`validation.json`")
            .check(record.page(), javaClass, "core")
    }

    @Test
    fun `what was measured anew takes the place of what was, and keeps its source`() {
        val old = ValidationRow("|Δ| of a", "0.10000", "0.2", "± 1.00 %", "no", "S", "`T`")
        val record = ValidationRecord(listOf(ValidationGroup("g", "n", "", listOf("a", "b"), listOf(old))))
        val seen = listOf(
            "| |Δ| of a | 0.10000 | 0.3 | ± 1.00 % | ok |",
            "| |Δ| of a | 0.10000 | 0.100001 | ± 1.00 % | ok |",
            "| b | 1.00000 | 2.00000 | ± 0.1 | FAILED |",
        )
        val now = record.with(seen)
        assertEquals(old.copy(measured = "0.100001", ok = "ok"), now.groups.first().rows.single())
        assertEquals("no", now.groups.single { it.group == ValidationRecord.FURTHER }.rows.single().ok)
        assertEquals(record.groups, record.with(emptyList()).groups)
        assertTrue("- g: \\|Δ\\| of a, 0.2 and not 0.10000." in record.page()) { record.page() }
        assertTrue("| b | 1.00000 | 2.00000 | ± 0.1 | **no** |" in now.page()) { now.page() }
    }
}
