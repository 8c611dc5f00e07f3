package daphnis.app

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What `describe` says of materials and of laws by pair. */
class DescribeMaterialsTest {
    @Test
    fun `each material has a line, and so has each contact`() {
        val pair = """{"between":["light","heavy"],"restitution":{"type":"constant","coefficient":0.5}}"""
        val like = """{"between":["heavy","heavy"],"roughness":{"type":"constant","coefficient":0.3}}"""
        val text = describe("mixture", "contacts=[$pair,$like]", "box.lengths=[60,60,60]", BODY)
        assertTrue("heavy: 2000 spheres, radius 1 length unit, mass 8 mass units" in row(text, "materials")) { text }
        assertTrue("light: 2000 spheres, radius 0.5 length units, mass 1 mass unit" in text) { text }
        assertTrue("moon: 1 sphere, radius 5 length units" in text && "of moon, at 0 length units" in text) { text }
        assertTrue("light with heavy: restitution 0.5 at every speed" in row(text, "contacts")) { text }
        assertTrue("heavy with heavy: roughness constant, β = 0.3 (-1 smooth, 1 perfectly rough)" in text) { text }
        val others = " (pairs with no other in contacts)"
        assertEquals("0.9 at every speed$others", row(text, "restitution").replace(Regex("\\s+"), " "))
        assertTrue(row(text, "roughness").startsWith("smooth$others; moment of inertia")) { text }
        val alone = row(describe("mixture", "contacts=[$like]"), "restitution")
        assertEquals("0.9 at every speed", alone)
        fun contact(law: String) = row(
            describe("mixture", "contacts=[{\"between\":[\"light\",\"light\"],\"restitution\":$law}]"),
            "contacts",
        ).replace(Regex("\\s+"), " ").substringAfter("restitution ")
        val law = "{\"type\":\"viscoelastic\",\"coefficient\":0.6,\"speed\":2"
        assertEquals("viscoelastic, 0.6 at 2 cm/s", contact("$law}"))
        assertEquals(
            "viscoelastic, 0.6 at 2 cm/s of two spheres of radius 1 length unit and mass 3 mass units",
            contact("$law,\"radius\":1,\"mass\":3}"),
        )
        assertEquals("bridges, 0.34 v^-0.234 with v in cm/s", contact("{\"type\":\"bridges\"}"))
        assertEquals("table of 1 point, 0.5 at 2 cm/s", contact("{\"type\":\"table\",\"points\":[[2,0.5]]}"))
        val plain = describe("cooling-gas")
        assertFalse("materials" in plain || "contacts" in plain) { plain }
    }

    private companion object {
        const val BODY = """bodies=[{"radius":5,"position":[0,0,0],"material":"moon","density":1}]"""
    }
}
