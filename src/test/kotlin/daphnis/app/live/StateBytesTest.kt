package daphnis.app.live

import daphnis.analysis.insitu.State
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.table.UnitNames
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ImageShear
import daphnis.core.hill.HillSheet
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Random
import kotlin.math.abs
import kotlin.math.hypot

/** The bytes of a state, taken apart as the page does. */
internal class DecodedState(bytes: ByteArray) {
    private val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
    val head: JsonObject
    val count: Int
    val columns: List<FloatArray>
    val material: ByteArray
    val start: Int

    init {
        val text = ByteArray(buffer.getInt())
        buffer.get(text)
        start = buffer.position()
        head = Json.parseToJsonElement(text.decodeToString()).jsonObject
        count = head.getValue("count").jsonPrimitive.content.toInt()
        columns = List(6) { FloatArray(count) { buffer.getFloat() } }
        material = ByteArray(count).also { buffer.get(it) }
        assertEquals(0, buffer.remaining())
    }

    fun text(key: String) = head.getValue(key).jsonPrimitive.content

    fun numbers(key: String) = head.getValue(key).jsonArray.map { it.jsonPrimitive.content.toDouble() }
}

class StateBytesTest {
    private fun StateBytes.of(state: State, number: Long) =
        of(state, SeenWalls(state.boundary, null, state.time), number)

    private val scale = PlotScale(UnitNames(null), 0.5, 2.0)

    private fun population(size: Int, shift: Double = 0.0): Population {
        val random = Random(39)
        fun column(edge: Double, middle: Double = 0.0) =
            DoubleArray(size) { middle + edge * (random.nextDouble() - 0.5) }
        return Population(
            column(10.0, shift), column(8.0), column(3.0), column(1.0), column(1.0), column(1.0),
            DoubleArray(size) {
                0.1 + random.nextDouble()
            },
            DoubleArray(size) { 0.1 + random.nextDouble() }, IntArray(size) { size - 1 - it },
        )
    }

    /** A box with faces along x and y, open along z, where v_y = -0.75 x is the mean flow. */
    private class Sheet(override val box: Box, override val meanFlow: MeanFlow? = MeanFlow(0, 1, -0.75)) :
        BoundaryConditions {
        override val shear = meanFlow?.let { ImageShear(box, it) }

        override fun contactFaces(axis: Int) = if (axis < 2) ContactFaces.PERIODIC else ContactFaces.OPEN

        override fun endStep(population: Population, time: Double) = Unit
    }

    private val sheet = Sheet(Box(-5.0, -4.0, Double.NEGATIVE_INFINITY, 5.0, 4.0, Double.POSITIVE_INFINITY))

    @Test
    fun `what is taken apart is the state to the precision of floats, without the mean flow`() {
        val p = population(200).withMaterial(IntArray(200) { it % 3 }, listOf("ice", "b", "c"))
        val seen = DecodedState(StateBytes(scale).of(State(p, sheet, 4.0), 12))
        assertEquals(200, seen.count)
        assertEquals(0, seen.start % 4)
        assertEquals("12", seen.text("number"))
        assertEquals(
            listOf("ice", "b", "c"),
            seen.head.getValue("materials").jsonArray.map {
                it.jsonPrimitive.content
            },
        )
        val origin = seen.numbers("origin")
        assertEquals(listOf(0.0, 0.0), origin.take(2))
        for (k in 0 until 200) {
            for (axis in 0..2) assertEquals(p.position(axis)[k], origin[axis] + seen.columns[axis][k], 1e-6)
            assertEquals(p.radius[k], seen.columns[3][k].toDouble(), 1e-6)
            // In units of r Ω = 1.
            val speed = hypot(hypot(p.vx[k], p.vy[k] + 0.75 * p.x[k]), p.vz[k])
            assertEquals(speed, seen.columns[4][k].toDouble(), 1e-6)
            assertEquals(p.mass[k], seen.columns[5][k].toDouble(), 1e-6)
            assertEquals(k % 3, seen.material[k].toInt())
        }
        // Four edges, in the middle of the open axis.
        val ends = seen.numbers("lines").chunked(3)
        assertEquals(8, ends.size)
        assertTrue(ends.all { (x, y, z) -> abs(x) == 5.0 && abs(y) == 4.0 && z == 0.0 }) { "$ends" }
        assertEquals(listOf(true, true), seen.head.getValue("repeats").jsonArray.map { "$it".toBoolean() })
        val shear = seen.head.getValue("shear").jsonObject.mapValues { "${it.value}".toDouble() }
        // In a time of 4 the image slides by -0.75 · 10 · 4, and three boxes of 8 less are -6, or 2.
        assertEquals(mapOf("normal" to 0.0, "slide" to 1.0, "offset" to 2.0), shear)
        assertEquals("1", seen.text("every"))
        assertEquals("v_y = -0.7500 x (rate in 1/(unit of time))", seen.text("flow"))
        assertTrue("200 spheres · box 10.00 × 8.000 × open" in seen.text("about")) { seen.text("about") }
        // An orbit takes 4 π.
        assertEquals("t = 0.3183 orbits", seen.text("time"))
        assertEquals("r Ω", seen.head.getValue("units").jsonObject.getValue("speed").jsonPrimitive.content)
    }

    @Test
    fun `of a sheet that breathes the box, the images and the flow are those of the time`() {
        val perturbed = HillSheet(Box.centred(10.0, 8.0, 3.0), 0.5, perturbation = 0.5)
        val p = population(20)
        fun seen(time: Double) = State(p, perturbed, time).let { state ->
            DecodedState(StateBytes(scale).of(state, SeenWalls(perturbed, null, time), 0))
        }
        assertEquals(2.5, seen(0.0).numbers("halves")[0], 1e-12)
        assertEquals(7.5, seen(2 * Math.PI).numbers("halves")[0], 1e-12)
        assertEquals("v_y = -0.5000 x (rate in 1/(unit of time))", seen(0.0).text("flow"))
        val quarter = seen(Math.PI)
        assertEquals(5.0, quarter.numbers("halves")[0], 1e-12)
        assertEquals("v_x = 0.2500 x, v_y = -0.7500 x (rates in 1/(unit of time))", quarter.text("flow"))
        for (k in 0 until 20) {
            val w = hypot(hypot(p.vx[k] - 0.25 * p.x[k], p.vy[k] + 0.75 * p.x[k]), p.vz[k])
            assertEquals(w, quarter.columns[4][k].toDouble(), 1e-5)
        }
    }

    @Test
    fun `without a mean flow speeds are as they are, and nothing is said of one`() {
        val p = population(20)
        val seen = DecodedState(StateBytes(scale).of(State(p, Sheet(sheet.box, null), 0.0), 0))
        for (k in 0 until 20) assertEquals(hypot(hypot(p.vx[k], p.vy[k]), p.vz[k]), seen.columns[4][k].toDouble(), 1e-6)
        assertEquals(JsonNull, seen.head.getValue("flow"))
        assertEquals(JsonNull, seen.head.getValue("shear"))
        assertTrue("flow" !in seen.text("about"))
    }

    @Test
    fun `a long box is long in plain digits`() {
        fun about(length: Double): String {
            val long = HillSheet(Box.centred(10.0, length, 8.0), 1.0)
            return DecodedState(StateBytes(scale).of(State(population(20), long, 0.0), 0)).text("about")
        }
        assertTrue("box 10.00 × 12600 × open" in about(12600.0)) { about(12600.0) }
        assertTrue("box 10.00 × 10000 × open" in about(9999.7)) { about(9999.7) }
        assertTrue("box 10.00 × 9999 × open" in about(9999.4)) { about(9999.4) }
        assertTrue("box 10.00 × 1.260e+08 × open" in about(1.26e8)) { about(1.26e8) }
    }

    @Test
    fun `far from the origin of open space places keep their precision`() {
        val p = population(50, 1e9)
        val seen = DecodedState(StateBytes(scale).of(State(p, BoundaryConditions.open(), 0.0), 0))
        val origin = seen.numbers("origin")
        assertEquals(1e9, origin[0], 1.0)
        for (k in 0 until 50) assertEquals(p.x[k], origin[0] + seen.columns[0][k], 1e-5)
        assertTrue(seen.numbers("halves").all { it in 1.0..7.0 }) { "${seen.numbers("halves")}" }
    }

    @Test
    fun `of too many spheres some are shown, the same in any order, but all bodies, which come first`() {
        val p = population(1000)
        // Ids from 990 on are bodies, which stand first in this population, last in another.
        val seen = DecodedState(StateBytes(scale, most = 300).of(State(p, sheet, 0.0, null, 990), 0))
        assertEquals(10, seen.text("bodies").toInt())
        assertEquals(10 + 248, seen.count)
        assertEquals("4", seen.text("every"))
        assertTrue("258 of 1000 spheres" in seen.text("about")) { seen.text("about") }
        val shown =
            (0 until 1000).filter { p.id[it] >= 990 } + (0 until 1000).filter { p.id[it] < 990 && p.id[it] % 4 == 0 }
        for ((place, k) in shown.withIndex()) assertEquals(p.radius[k].toFloat(), seen.columns[3][place])
    }

    @Test
    fun `discs lie in their plane, and nothing at all is a state too`() {
        val none = DoubleArray(0)
        val empty = Population(none, none, none, none, none, none, none, none)
        assertEquals(0, DecodedState(StateBytes(scale).of(State(empty, sheet, 0.0), 0)).count)
        val flat = doubleArrayOf(0.0, 0.0)
        val discs = Population(
            doubleArrayOf(-1.0, 1.0),
            flat,
            flat,
            flat,
            flat,
            flat,
            doubleArrayOf(0.5, 0.5),
            doubleArrayOf(1.0, 1.0),
        )
        val seen = DecodedState(StateBytes(scale).of(State(discs, Sheet(Box.flat(4.0, 4.0), null), 0.0), 0))
        assertEquals("2", seen.text("dimensions"))
        assertEquals(0.0, seen.numbers("halves")[2])
        assertTrue("2 discs · box 4.000 × 4.000 units of length" in seen.text("about")) { seen.text("about") }
    }
}
