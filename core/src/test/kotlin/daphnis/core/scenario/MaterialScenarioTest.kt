package daphnis.core.scenario

import daphnis.core.collision.GuardSpec
import daphnis.core.input.InputException
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.MaterialLaws
import daphnis.core.surface.MaterialRoughness
import daphnis.core.surface.Restitution
import daphnis.core.surface.SurfaceContact
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

/** Materials in scenarios; those from files are in [MaterialPlacementTest]. */
class MaterialScenarioTest {
    private fun scenario(vararg settings: String) = ScenarioJson.parse(
        """{
          "box": { "lengths": [60, 50, 40] }, "boundary": { "type": "periodic" },
          "particles": { "count": 1001, "materials": [
            { "name": "ice", "share": 0.25, "sizes": { "type": "equal", "radius": 0.5 }, "density": 0.9 },
            { "name": "rock", "share": 0.75,
              "sizes": { "type": "power-law", "minimum": 0.6, "maximum": 0.9, "exponent": 3 }, "mass": 8 } ] },
          "velocities": { "type": "gaussian", "temperature": 1 },
          "restitution": { "type": "constant", "coefficient": 1 },
          "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 1
        }""",
        "test",
        settings.toList(),
    )

    private fun setup(vararg settings: String) = ScenarioSetup.of(scenario(*settings), "test")

    private fun refused(vararg settings: String): String =
        assertThrows(InputException::class.java) { setup(*settings) }.message.orEmpty()

    private fun counts(p: Population) = List(p.materials.size) { m -> p.material.count { it == m.toDouble() } }

    @Test
    fun `each material has its share, its sizes and its masses`() {
        val p = setup().population
        assertEquals(listOf("ice", "rock"), p.materials)
        assertEquals(listOf(250, 751), counts(p))
        for (k in 0 until p.size) {
            if (p.material[k] == 0.0) {
                assertEquals(0.5, p.radius[k])
                assertEquals(0.9 * 4.0 / 3.0 * Math.PI * 0.125, p.mass[k], 1e-15)
            } else {
                assertTrue(p.radius[k] in 0.6..0.9)
                assertEquals(8.0, p.mass[k])
            }
        }
        assertTrue(p.radius.toSet().size > 700)
    }

    @Test
    fun `materials are mixed in the order of ids by the seed alone`() {
        val p = setup().population
        val changes = (1 until p.size).count { p.material[it] != p.material[it - 1] }
        // 2 · ¼ · ¾ of the neighbours differ, to four standard deviations.
        assertTrue(abs(changes - 375) < 60) { "$changes" }
        assertArrayEquals(p.material, setup("engine.threads=3", "engine.name=thread-pool").population.material)
        assertFalse(p.material.contentEquals(setup("seed=2").population.material))
        val lattice = setup("""placement={"type": "lattice", "lattice": "cubic"}""").population
        assertArrayEquals(p.material, lattice.material)
    }

    @Test
    fun `counts by material, and totals by volume, area and mass`() {
        val counted = """particles={"materials": [
            {"name": "a", "count": 7, "sizes": {"type": "list", "radii": [1, 2]}},
            {"name": "b", "count": 5, "sizes": {"type": "equal", "radius": 3}} ]}"""
        val p = setup(counted).population
        assertEquals(listOf(7, 5), counts(p))
        assertEquals(listOf(1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0), p.radius.filter { it < 3 }.sorted())
        val half = """[{"name": "a", "share": 0.5, "sizes": {"type": "equal", "radius": 1}, "density": 2},
            {"name": "b", "share": 0.5, "sizes": {"type": "equal", "radius": 0.5}, "mass": 3}]"""
        fun total(key: String) = setup("""particles={$key, "materials": $half}""").population
        val volume = 4.0 / 3.0 * Math.PI
        for ((key, wanted, measure) in listOf(
            Triple("\"fillingFactor\": 0.1", 0.1 * 120000) { q: Population, k: Int ->
                volume *
                    Math.pow(q.radius[k], 3.0)
            },
            Triple("\"opticalDepth\": 0.8", 0.8 * 3000) { q: Population, k: Int ->
                Math.PI * q.radius[k] * q.radius[k]
            },
            Triple("\"surfaceDensity\": 1.5", 1.5 * 3000) { q: Population, k: Int -> q.mass[k] },
        )) {
            val q = total(key)
            val (a, b) = counts(q)
            assertTrue(abs(a - b) <= 1) { "$key: $a, $b" }
            val sum = (0 until q.size).sumOf { measure(q, it) }
            assertTrue(abs(sum - wanted) <= volume * 2) { "$key: $sum" }
        }
    }

    @Test
    fun `a scenario without materials is drawn and written as before`() {
        val text = ScenarioJson.write(scenario("""particles={"count": 9, "sizes": {"type": "equal", "radius": 1}}"""))
        for (word in listOf("material", "contacts", "share")) assertFalse(word in text) { text }
        val p = setup("""particles={"count": 9, "sizes": {"type": "equal", "radius": 1}}""").population
        assertFalse(p.hasMaterials)
        // One material is as none, but for its name.
        val one = """particles={"count": 9, "materials": [
            {"name": "ice", "share": 1, "sizes": {"type": "equal", "radius": 1}}]}"""
        val q = setup(one).population
        for (place in 0..7) assertArrayEquals(p.column(place), q.column(place))
        assertEquals(listOf(9), counts(q))
    }

    @Test
    fun `bodies have materials of their own or of other spheres`() {
        val moonlet = """{"radius": 5, "position": [0, 0, 0], "material": "moonlet", "density": 2}"""
        val berg = """{"radius": 3, "position": [20, 0, 0], "material": "ice"}"""
        val setup = setup("bodies=[$moonlet, $berg]", "particles.count=50")
        val p = setup.population
        assertEquals(listOf("ice", "rock", "moonlet"), p.materials)
        assertEquals(listOf(2.0, 0.0), p.material.takeLast(2))
        assertEquals(0.9 * 4.0 / 3.0 * Math.PI * 27, p.mass.last(), 1e-12)
        assertEquals(listOf("ice", "rock", "moonlet"), setup.scenario.materials)
        val plain = """particles={"count": 9, "sizes": {"type": "equal", "radius": 1}}"""
        val other = setup(plain, "bodies=[$moonlet, {\"radius\": 3, \"position\": [20, 0, 0]}]").population
        assertEquals(listOf("particles", "moonlet"), other.materials)
        assertEquals(List(9) { 0.0 } + listOf(1.0, 0.0), other.material.toList())
        val light = """bodies=[{"radius": 5, "position": [0, 0, 0], "material": "moonlet"}]"""
        assertTrue("bodies[0].density: is missing" in refused(light))
        assertTrue(
            "bodies[0].material: is missing; give one of ice, rock" in
                refused("bodies=[{\"radius\": 3, \"position\": [0, 0, 0]}]"),
        )
    }

    @Test
    fun `contacts have what they say, and else what all have`() {
        assertTrue(setup().restitution is ConstantRestitution)
        assertNull(setup().roughness)
        val both = setup(
            "roughness=$ROUGH",
            """contacts=[{"between": ["rock", "ice"], "restitution": {"type": "constant", "coefficient": 0.5}},
            {"between": ["ice", "ice"], "roughness": {"type": "smooth"}}]""",
        )
        assertTrue(both.population.hasSpin)
        val contact = SurfaceContact.headOn(1.0, 1.0, 1.0)
        fun between(first: Int, second: Int) = contact.apply {
            firstMaterial = first
            secondMaterial = second
        }
        assertEquals(0.5, both.restitution.restitution(between(0, 1)))
        assertEquals(1.0, both.restitution.restitution(between(1, 1)))
        assertEquals(0.0, both.roughness!!.change(between(0, 0)))
        assertEquals(1.25, both.roughness!!.change(between(1, 0)))
        // A part that no pair changes stays what it is, so that smooth spheres with one ε have the quick way.
        val surfaces = setup("""contacts=[{"between": ["ice", "ice"], "roughness": $ROUGH}]""")
        assertTrue(surfaces.restitution is Restitution && surfaces.roughness is MaterialRoughness)
        assertTrue(surfaces.population.hasSpin)
        val normal =
            setup("""contacts=[{"between": ["ice", "ice"], "restitution": {"type": "constant", "coefficient": 0.5}}]""")
        assertTrue(normal.restitution is MaterialLaws && normal.roughness == null && !normal.population.hasSpin)
    }

    @Test
    fun `a viscoelastic law of a pair is measured by the two spheres that it is of`() {
        val moon = "bodies=[{\"radius\": 2, \"position\": [0, 0, 0], \"material\": \"moon\", \"mass\": 50}]"
        val law = "{\"type\": \"viscoelastic\", \"coefficient\": 0.6, \"speed\": 0.3"
        fun between(pair: String, more: String = "") = arrayOf(
            moon,
            "contacts=[{\"between\": [$pair], \"restitution\": $law$more}}]",
        )
        val ice = 0.9 * 4.0 / 3.0 * Math.PI * 0.125
        val unlike = setup(*between("\"moon\", \"ice\"")).restitution
        val contact = SurfaceContact.headOn(0.3, 2 * 2.0 * 0.5 / 2.5, 2 * 50 * ice / (50 + ice))
        contact.firstMaterial = 0
        contact.secondMaterial = 2
        assertEquals(0.6, unlike.restitution(contact), 1e-12)
        val like = setup(*between("\"ice\", \"ice\"")).restitution
        val two = SurfaceContact.headOn(0.3, 0.5, ice)
        assertEquals(0.6, like.restitution(two), 1e-12)
        // Given, they are what is said.
        val given = setup(*between("\"ice\", \"ice\"", ", \"radius\": 1, \"mass\": 1")).restitution
        assertEquals(0.6, given.restitution(SurfaceContact.headOn(0.3, 1.0, 1.0)), 1e-12)
        assertTrue(abs(given.restitution(two) - 0.6) > 0.01)
        val key = "contacts[0].restitution.radius: is missing"
        assertTrue("$key; give that of two spheres" in refused(*between("\"ice\", \"rock\"")))
        assertTrue("'rock' is not known to have one radius" in refused(*between("\"ice\", \"rock\"")))
        assertTrue("$key; give both" in refused(*between("\"ice\", \"ice\"", ", \"mass\": 1")))
        val berg = moon.replace("\"moon\"", "\"ice\"")
        assertTrue("'ice' is not known" in refused(berg, between("\"ice\", \"ice\"")[1]))
        val plain = "particles={\"count\": 9, \"mass\": 3, \"sizes\": {\"type\": \"equal\", \"radius\": 1}}"
        val others = setup(plain, *between("\"particles\", \"particles\"")).restitution
        assertEquals(0.6, others.restitution(SurfaceContact.headOn(0.3, 1.0, 3.0)), 1e-12)
    }

    @Test
    fun `the default guard is there where any pair is inelastic at all speeds`() {
        assertTrue(setup().scenario.guard is GuardSpec.None)
        val one = """contacts=[{"between": ["ice", "rock"], "restitution": {"type": "constant", "coefficient": 0.5}}]"""
        assertTrue(setup(one).scenario.guard is GuardSpec.FloorSpeed)
    }

    @Test
    fun `impacts are listed for each pair`() {
        val one = """contacts=[{"between": ["rock", "ice"], "restitution": {"type": "constant", "coefficient": 0.5}}]"""
        val impacts = scenario(one).impacts
        assertEquals(listOf("ice ice", "ice rock", "rock rock"), impacts.map { it.between.joinToString(" ") })
        assertEquals(listOf(1.0, 0.5, 1.0), impacts.map { it.restitution!!.constant })
    }

    @Test
    fun `what is wrong is said in one line with its key`() {
        val materials = "particles.materials"
        val wrong = listOf(
            "$materials[0].share=0.3" to "$materials: have shares that add up to 1.05; they must add up to 1",
            "$materials[0].share=0" to "$materials[0].share: is 0.0; must be in (0, 1]",
            "$materials[0].name=" to
                "$materials[0].name: is ''; it must be a word of at most 64 letters, digits, _ and -",
            "$materials[1].name=ice" to "$materials[1].name: is 'ice', which another material is called",
            "$materials[1].count=5" to "$materials[0]: needs a share or a count",
            "$materials=[]" to "$materials: is empty; name one or leave it out",
            """particles.sizes={"type": "equal", "radius": 1}""" to
                "particles.sizes: must be left out where there are materials",
            "particles.density=2" to "particles.density: must be left out",
            "particles.mass=2" to "particles.mass: must be left out",
            "$materials[1].sizes.minimum=-1" to "$materials[1].sizes: ",
            "$materials[1].mass=0" to "$materials[1].mass: is 0.0; must be > 0",
            contacts("\"ice\"") to "contacts[0].between: is [ice]; must be the names of two materials",
            contacts("\"ice\", \"rok\"") to "contacts[0].between: is 'rok'; did you mean 'rock'? known: ice, rock",
            """contacts=[$PAIR, {"between": ["rock", "ice"], "roughness": $ROUGH}]""" to
                "contacts[1].between: names rock, ice a second time",
            """contacts=[{"between": ["ice", "ice"]}]""" to
                "contacts[0]: says nothing; give restitution, roughness, interaction, or several",
            """contacts=[{"between": ["ice", "ice"], "roughness": {"type": "smooth", "momentFactor": 0.5}}]""" to
                "contacts[0].roughness.momentFactor: is that of all spheres",
            """contacts=[{"between": ["ice", "ice"], "roughness": {"type": "constant", "coefficient": 2}}]""" to
                "contacts[0].roughness.coefficient: is 2.0; must be in [-1, 1]",
            """contacts=[{"between": ["ice", "ice"], "restitution": {"type": "constant", "coefficient": 2}}]""" to
                "contacts[0].restitution.coefficient: is 2.0; must be in [0, 1]",
        )
        for ((setting, message) in wrong) {
            assertTrue("test: $message" in refused(setting)) { "$setting: ${refused(setting)}" }
        }
        val counted = """particles={"count": 3, "materials": [
            {"name": "a", "count": 7, "sizes": {"type": "equal", "radius": 1}}]}"""
        assertTrue("particles: needs none of count, fillingFactor" in refused(counted)) { refused(counted) }
        val plain = """particles={"count": 9, "sizes": {"type": "equal", "radius": 1}}"""
        assertTrue("contacts: are between materials, of which none is named" in refused(plain, "contacts=[$PAIR]"))
        assertTrue("particles.sizes: is missing" in refused("""particles={"count": 9}"""))
    }

    private fun contacts(pair: String) = """contacts=[{"between": [$pair], "roughness": $ROUGH}]"""

    private companion object {
        const val ROUGH = """{"type": "constant", "coefficient": 0.25}"""
        const val PAIR = """{"between": ["ice", "rock"], "roughness": $ROUGH}"""
    }
}
