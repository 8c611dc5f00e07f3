package daphnis.analysis.report

import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class FreeCoolingTest {
    private fun isOf(name: String, vararg settings: String) =
        FreeCooling.isOf(BuiltIn.scenario(name, settings.asList()), dispersion = 0.1)

    @Test
    fun `surfaces that rub cool a gas for ever, however elastic its impacts are`() {
        fun rough(law: String) = isOf("elastic-gas", "roughness={$law}")
        assertEquals(true, rough(""""type":"constant","coefficient":0.5"""))
        assertEquals(true, rough(""""type":"coulomb","friction":0.1,"sticking":0"""))
        for (end in listOf(-1, 1)) assertEquals(false, rough(""""type":"constant","coefficient":$end"""))
        assertEquals(false, rough(""""type":"smooth""""))
        assertEquals(false, rough(""""type":"coulomb","friction":0,"sticking":0"""))
        val floor = "guard={\"type\":\"floor-speed\",\"speed\":0.17}"
        assertEquals(true, isOf("rough-gas", floor))
        val constant = "\"type\":\"constant\",\"coefficient\":0.5"
        assertEquals(true, isOf("cooling-gas", "restitution={\"type\":\"bridges\"}", "roughness={$constant}"))
        assertEquals(false, isOf("ring-patch", "roughness={\"type\":\"constant\",\"coefficient\":0}"))
    }

    @Test
    fun `a mixture cools for ever when impacts of any pair of materials take energy`() {
        val elastic = "restitution.coefficient=1"
        fun pair(names: String, law: String) = """{"between":[$names],$law}"""
        val sticky = """"restitution":{"type":"constant","coefficient":0.5}"""
        val rough = """"roughness":{"type":"constant","coefficient":0.5}"""
        val unlike = """"heavy","light""""
        assertEquals(true, isOf("mixture"))
        assertEquals(false, isOf("mixture", elastic))
        assertEquals(true, isOf("mixture", elastic, "contacts=[${pair(unlike, sticky)}]"))
        assertEquals(true, isOf("mixture", elastic, "contacts=[${pair(unlike, rough)}]"))
        val all = listOf(unlike, """"heavy","heavy"""", """"light","light"""")
        val one = """"restitution":{"type":"constant","coefficient":1}"""
        assertEquals(false, isOf("mixture", "contacts=[${all.joinToString { pair(it, one) }}]"))
    }

    @Test
    fun `walls that move, turn, have a belt or a temperature heat a gas`() {
        fun within(face: String) = isOf("cooling-gas", """boundary={"type":"walls","faces":{"lowerZ":{$face}}}""")
        assertEquals(true, within(""""restitution":0.5"""))
        assertEquals(false, within(""""temperature":1"""))
        fun moving(law: String) = within(""""motion":{$law}""")
        assertEquals(false, moving(""""type":"sine","amplitude":0.1,"frequency":1"""))
        assertEquals(false, moving(""""type":"sawtooth","amplitude":0.1,"frequency":1"""))
        assertEquals(false, moving(""""type":"bi-parabolic","amplitude":0.1,"frequency":1"""))
        assertEquals(true, moving(""""type":"bi-parabolic","amplitude":0,"frequency":1"""))
        assertEquals(false, moving(""""type":"piston","mass":1,"force":1"""))
        assertEquals(false, moving(""""type":"steady","velocity":1"""))
        assertEquals(true, moving(""""type":"steady","velocity":0"""))
        fun around(surface: String) = isOf("cooling-gas", """boundary={"type":"walls","surfaces":[{$surface}]}""")
        val plane = """"type":"plane","point":[0,0,0],"normal":[0,0,1]"""
        assertEquals(true, around(plane))
        assertEquals(false, around("""$plane,"belt":[1,0,0]"""))
        assertEquals(false, around("""$plane,"temperature":1"""))
        assertEquals(false, around("""$plane,"motion":{"type":"sine","amplitude":0.1,"frequency":1}"""))
        assertEquals(true, around(""""type":"sphere","radius":1"""))
        assertEquals(false, around(""""type":"sphere","radius":1,"angularVelocity":[0,0,1]"""))
        assertEquals(true, around(""""type":"cylinder","axis":[1,0,0],"radius":1"""))
        assertEquals(false, isOf("drum"))
        assertEquals(true, isOf("drum", "boundary.surfaces=[]"))
    }

    @Test
    fun `inelastic spheres cool for ever unless something heats them, or slow impacts are elastic`() {
        assertEquals(true, isOf("cooling-gas"))
        assertEquals(true, isOf("cooling-gas", "boundary={\"type\":\"walls\"}"))
        assertEquals(true, isOf("cooling-gas", "boundary={\"type\":\"lees-edwards\",\"shearRate\":0}"))
        assertEquals(false, isOf("cooling-gas", "restitution.coefficient=1"))
        assertEquals(false, isOf("cooling-gas", "restitution={\"type\":\"bridges\"}"))
        assertEquals(true, isOf("cooling-gas", "guard={\"type\":\"floor-speed\",\"speed\":0.16}"))
        assertEquals(false, isOf("cooling-gas", "guard={\"type\":\"floor-speed\",\"speed\":0.17}"))
        fun by(law: String) = isOf("cooling-gas", "restitution={$law}")
        assertEquals(true, by(""""type":"viscoelastic","coefficient":0.99,"speed":1"""))
        assertEquals(false, by(""""type":"viscoelastic","coefficient":1,"speed":1"""))
        assertEquals(true, by(""""type":"step","coefficient":0.5,"speed":1,"below":0.9"""))
        assertEquals(false, by(""""type":"step","coefficient":0.5,"speed":1"""))
        assertEquals(true, by(""""type":"table","points":[[1,0.9],[2,1]]"""))
        assertEquals(false, by(""""type":"table","points":[[1,1],[2,0.5]]"""))
        assertEquals(false, isOf("elastic-gas"))
        assertEquals(false, isOf("shear-cell"))
        for (driven in listOf("paper-figure-1", "ring-patch", "self-gravity-wakes")) {
            assertEquals(false, isOf(driven, "restitution={\"type\":\"constant\",\"coefficient\":0.5}")) { driven }
        }
    }
}
