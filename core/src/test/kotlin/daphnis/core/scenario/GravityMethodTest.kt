package daphnis.core.scenario

import daphnis.core.force.MeshGravity
import daphnis.core.force.RadialGravity
import daphnis.core.force.SelfGravity
import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class GravityMethodTest {
    private fun setup(keys: String, vararg settings: String) = ScenarioSetup.of(
        BuiltIn.scenario(
            "ring-patch",
            listOf("box.lengths=[60,60,20]", """forces=[{"type":"self-gravity"$keys}]""", *settings),
        ),
        "patch",
    )

    private fun refused(keys: String, vararg settings: String): String =
        assertThrows(InputException::class.java) { setup(keys, *settings) }.message!!

    @Test
    fun `each method makes its force with its keys`() {
        assertEquals(SelfGravity::class, setup("").forces[0]::class)
        assertEquals(SelfGravity::class, setup(""","method":"tree","images":2""").forces[0]::class)
        val mesh = setup(""","method":"mesh","softening":0.1,"spacing":5""").forces[0] as MeshGravity
        assertEquals(0.1, mesh.softening)
        assertEquals(5.0, mesh.spacing)
        val waves = setup(""","method":"radial-modes","modes":12""").forces[0] as RadialGravity
        assertEquals(12, waves.modes)
    }

    @Test
    fun `a key of another method, a number out of range and a box that does not fit are refused in one line`() {
        for ((keys, said) in listOf(
            ""","method":"mesh","openingAngle":0.3""" to "forces[0].openingAngle: goes with the method tree",
            ""","method":"mesh","images":2""" to "forces[0].images: goes with the method tree",
            ""","method":"mesh","modes":2""" to "forces[0].modes: goes with the method radial-modes",
            ""","method":"mesh","spacing":0""" to "forces[0].spacing: is 0.0; must be > 0",
            ""","method":"mesh","spacing":0.01""" to
                "forces[0].spacing: is 0.01; makes more than 4000000 points in a plane; take a greater one",
            ""","spacing":5""" to "forces[0].spacing: goes with the method mesh",
            ""","method":"radial-modes"""" to "forces[0].modes: is missing; radial-modes needs it",
            ""","method":"radial-modes","modes":0""" to "forces[0].modes: is 0; must be in 1..4096",
            ""","method":"radial-modes","modes":4,"softening":1""" to
                "forces[0].softening: goes with the methods tree and mesh",
        )) {
            assertEquals("patch: $said", refused(keys))
        }
        assertEquals(
            "patch: forces[0].method: is mesh; it needs a box that repeats along x and y, slides along y if at all, " +
                "and is open along z",
            refused(""","method":"mesh"""", """boundary={"type":"hill-sheet","radiallyOpen":true}"""),
        )
        assertEquals(
            "patch: forces[0].method: is radial-modes; it needs a box that repeats along x and has a length along y",
            refused(""","method":"radial-modes","modes":4""", """boundary={"type":"hill-sheet","radiallyOpen":true}"""),
        )
    }

    @Test
    fun `who sums waves along x is not told that there is no room for wakes, nor to follow pairs`() {
        val heavy = listOf("particles.density=9000", "timeStep.steps=100", "box.lengths=[60,60,20]")
        fun warnings(keys: String) = setup(keys, *heavy.toTypedArray()).let { warnings(it) }
        assertEquals(2, warnings("").size)
        assertEquals(emptyList<String>(), warnings(""","method":"radial-modes","modes":12"""))
    }

    @Test
    fun `a mesh coarser than its patch, one of too many points and a second gravity are refused in one line`() {
        val soft = refused(""","method":"mesh","softening":3""")
        assertEquals(
            "patch: forces[0].softening: is 3.0; makes the mesh coarser than the patch is wide; take the tree",
            soft,
        )
        setup(""","method":"mesh","softening":1.5""")
        val high = """bodies=[{"radius":1,"mass":1,"position":[0,0,800]}]"""
        val why = refused(""","method":"mesh"""", high)
        assertTrue("forces[0].method: is mesh, for flat patches; spheres from" in why) { why }
        val wide = arrayOf("box.lengths=[1990,1990,20]", "particles.opticalDepth=0.0005")
        val many = refused(""","method":"mesh","spacing":1""", *wide)
        assertTrue("forces[0].spacing: makes a mesh of " in many) { many }
        val twice = """forces=[{"type":"self-gravity"},{"type":"self-gravity","method":"radial-modes","modes":3}]"""
        val second = refused("", twice)
        assertEquals("patch: forces[1]: is self-gravity of all spheres, as forces[0] is; one is enough", second)
    }
}
