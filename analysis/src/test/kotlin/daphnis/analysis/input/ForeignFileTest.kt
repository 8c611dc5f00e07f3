package daphnis.analysis.input

import daphnis.analysis.diffusion.Coordinate
import daphnis.analysis.diffusion.Trajectories
import daphnis.core.boundary.Box
import daphnis.core.boundary.ImageShear
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.format.ExportOptions
import daphnis.core.format.FormatException
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormats
import daphnis.core.input.InputException
import daphnis.core.population.VelocityMoments
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random

/** Files of other programs, as states that can be analysed. */
class ForeignFileTest {
    @TempDir
    lateinit var home: Path

    private fun file(name: String, text: String) = Files.writeString(home.resolve(name), text)

    private fun input(path: Path, timeStep: Double? = null) = AnalysisInput.ofFile(path, null, "", timeStep)

    private fun refused(vararg words: String, act: () -> Unit) {
        val e = assertThrows(RuntimeException::class.java, act)
        assertTrue(e is FormatException || e is InputException) { "$e" }
        for (word in words) assertTrue(word in e.message!!) { "'$word' is not in ${e.message}" }
    }

    private fun snapshot(
        step: Long,
        time: Double,
        position: Array<DoubleArray>,
        velocity: Array<DoubleArray> = Array(3) { DoubleArray(position[0].size) },
        lengths: DoubleArray = doubleArrayOf(10.0, 10.0, 10.0),
        offset: Double = 0.0,
        axes: Pair<Int, Int> = 1 to 0,
        id: IntArray = IntArray(position[0].size) { it + 1 },
    ): Snapshot {
        val ones = DoubleArray(id.size) { 1.0 }
        val radius = DoubleArray(id.size) { 0.1 }
        return Snapshot(
            step, time, lengths, BooleanArray(3) { true }, offset, id, position, velocity, radius, ones, axes.first,
            axes.second,
        )
    }

    private fun export(word: String, states: List<Snapshot>): Path {
        val directory = Files.createDirectories(home.resolve(word))
        return SnapshotFormats.named(word).export(states.asSequence(), directory, ExportOptions("0")).path
    }

    @Test
    fun `every state is in its own box, with its own faces`() {
        val text = listOf("20 T", "10 F", "16 T").withIndex().joinToString("") { (k, said) ->
            val (l, z) = said.split(' ')
            "1\nLattice=\"$l 0 0 0 $l 0 0 0 $l\" Time=$k pbc=\"T T $z\" Properties=pos:R:3:radius:R:1\n3 3 3 1\n"
        }
        val input = input(file("a.xyz", text))
        val boundaries = (0..2).map { input.state(it).boundary }
        assertEquals(listOf(20.0, 10.0, 16.0), boundaries.map { it.box.length(0) })
        assertEquals(listOf(true, false, true), boundaries.map { it.repeats(2) })
        assertEquals(listOf(-7.0, -2.0, -5.0), (0..2).map { input.state(it).population.x[0] })
    }

    /** A walk of 40 particles over [count] states, without a box, in steps of about [step]. */
    private fun walk(count: Int, step: Double): List<Array<DoubleArray>> {
        val random = Random(7)
        val at = Array(3) { DoubleArray(40) { random.nextDouble() * 10 - 5 } }
        return List(count) {
            for (axis in 0..2) for (k in 0 until 40) at[axis][k] += step * random.nextGaussian()
            Array(3) { at[it].copyOf() }
        }
    }

    @ParameterizedTest
    @CsvSource("xyz,1.0", "lammps,1.0", "h5md,1.0", "xyz,6.0", "h5md,6.0")
    fun `places beyond the box are in it for pairs, and as they were for displacements`(format: String, step: Double) {
        val walk = walk(8, step)
        val path = export(format, walk.mapIndexed { k, p -> snapshot(k.toLong(), k.toDouble(), p) })
        val input = input(path)
        val followed = Trajectories((0..2).map { Coordinate.Position(it) }, input.idsThroughout())
        for (k in walk.indices) {
            val state = input.state(k).population
            for (axis in 0..2) assertTrue(state.position(axis).all { it in -5.0..5.0 })
            for (i in 0 until 40) assertEquals(0.0, Math.IEEEremainder(state.x[i] - walk[k][0][i], 10.0), 1e-9)
            followed.add(input.snapshot(k))
        }
        for (k in walk.indices) {
            for (axis in 0..2) {
                val mean = walk[k][axis].average()
                val there = walk[k][axis].map { it - mean }.toDoubleArray()
                assertArrayEquals(there, followed.at(k, axis), 1e-9)
            }
        }
    }

    @Test
    fun `a hair outside does not make places that jump to the other side unwrapped`() {
        val walk = walk(8, 1.0).mapIndexed { k, p ->
            val folded = snapshot(k.toLong(), k.toDouble(), p).folded().position
            snapshot(k.toLong(), k.toDouble(), Array(3) { a -> DoubleArray(40) { folded[a][it] * 1.01 } })
        }
        val input = input(export("xyz", walk))
        assertNull(input.snapshot(3).image)
        assertTrue((0..7).all { k -> input.state(k).population.x.all { it in -5.0..5.0 } })
    }

    @ParameterizedTest
    @CsvSource("0,0", "105,0", "15,0", "-0.3,0", "0,5e-7", "105,5e-7")
    fun `places in a box that begins anywhere are wrapped, also with one a hair outside`(shift: Double, hair: Double) {
        val walk = walk(30, 0.6)
        val states = walk.mapIndexed { k, p ->
            val folded = snapshot(k.toLong(), k.toDouble(), p).folded().position
            val places = Array(3) { a -> DoubleArray(40) { folded[a][it] + shift } }
            if (k == 7) places[0][3] = shift - 5 - hair
            snapshot(k.toLong(), k.toDouble(), places)
        }
        val input = input(export("h5md", states))
        assertNull(input.snapshot(3).image)
        assertTrue(input.notices.none { "unwrapped" in it }) { "${input.notices}" }
        assertTrue((0 until 30).all { k -> input.state(k).population.x.all { it in -5.0..5.0 } })
    }

    @Test
    fun `places that go on beyond the box are said, also of one particle`() {
        for (speed in listOf(0.8, 3.0, 7.0)) {
            val states = List(20) { k -> snapshot(k.toLong(), k.toDouble(), Array(3) { doubleArrayOf(speed * k) }) }
            val input = input(export("h5md", states))
            assertTrue(input.notices.any { "taken as unwrapped" in it }) { "$speed: ${input.notices}" }
            assertEquals((speed * 19 / 10 + 0.5).toInt(), input.snapshot(19).image!![0][0])
        }
    }

    @Test
    fun `a wrapped box whose beginning moves is wrapped`() {
        val states = walk(30, 0.3).mapIndexed { k, p ->
            // Some of them jump by a box, over 1.8 boxes in all.
            val corner = DoubleArray(3) { 4.0 * (k / 10) }
            fun placed(a: Int, x: Double) = x - 10 * Math.floor((x - corner[a]) / 10)
            snapshot(k.toLong(), k.toDouble(), Array(3) { a -> DoubleArray(40) { placed(a, p[a][it]) } })
        }
        assertNull(input(export("xyz", states)).snapshot(3).image)
    }

    private fun row(step: Long, time: String, x: Double, id: Int = 3) =
        "2\nLattice=\"9 0 0 0 9 0 0 0 9\" Step=$step $time Properties=id:I:1:pos:R:3:radius:R:1\n1 1 1 1 .1\n$id $x 4 4 .1\n"

    @Test
    fun `steps are no times, unless the time of a step is given`() {
        val path = file("a.xyz", row(0, "", 1.0) + row(50, "", 2.0))
        val silent = input(path)
        assertFalse(silent.hasTimes)
        assertEquals("steps", silent.units.time)
        assertTrue(silent.notices.any { "has no times" in it }) { "${silent.notices}" }
        val told = input(path, 0.02)
        assertTrue(told.hasTimes)
        assertArrayEquals(doubleArrayOf(0.0, 1.0), told.times)
        assertEquals("units of time", told.units.time)
        assertTrue(told.notices.none { "has no times" in it }) { "${told.notices}" }
        for (wrong in listOf(0.0, -1.0, Double.NaN)) refused("timeStep", "must be > 0") { input(path, wrong) }
        val known = file("b.xyz", row(0, "Time=0", 1.0) + row(50, "Time=2", 2.0))
        assertTrue(input(known).hasTimes)
        refused("timeStep", "leave it out", "has times") { input(known, 0.02) }
        refused("timeStep", "has times") { input(file("e.xyz", row(0, "Time=1", 1.0)), 0.02) }
        refused("frame 1 has no time", "frame 0 has one") {
            input(file("c.xyz", row(0, "Time=0", 1.0) + row(50, "", 2.0)))
        }
        assertTrue(input(file("d.xyz", row(7, "", 1.0))).hasTimes)
        val ring = BuiltIn.scenario("ring-patch", listOf("box.lengths=[9,9,9]"))
        refused("timeStep", "is missing", "no times") { AnalysisInput.ofFile(path, ring, "ring") }
    }

    @ParameterizedTest
    @ValueSource(strings = ["Time=%d", ""])
    fun `a frame twice is left out and said, another of the same time is refused`(time: String) {
        fun frame(k: Int, x: Double) = row(10L * k, time.format(k), x)
        val input = input(file("a.xyz", frame(0, 1.0) + frame(1, 2.0) + frame(1, 2.0000000001) + frame(2, 3.0)))
        assertEquals(3, input.size)
        assertTrue(input.notices.any { "frame 2 is frame 1 again" in it }) { "${input.notices}" }
        // A run that went on from an earlier state.
        val again = input(file("b.xyz", frame(0, 1.0) + frame(1, 2.0) + frame(0, 1.0) + frame(1, 2.0) + frame(2, 3.0)))
        assertEquals(3, again.size)
        refused("frames 1 and 2", "differ") { input(file("c.xyz", frame(0, 1.0) + frame(1, 2.0) + frame(1, 2.1))) }
        refused("frame 2", "must ascend") { input(file("d.xyz", frame(1, 1.0) + frame(2, 2.0) + frame(0, 3.0))) }
    }

    @Test
    fun `a frame twice may be wrapped otherwise, but not in another box`() {
        fun frame(box: String, x: Double) =
            "1\nLattice=\"$box\" Origin=\"-5 -5 -5\" Time=1 Properties=id:I:1:pos:R:3:radius:R:1\n1 $x 4 4 .1\n"
        val box = "10 0 0 0 10 0 0 0 10"
        val again = input(file("a.xyz", frame(box, 4.9) + frame(box, -5.1)))
        assertEquals(1, again.size)
        assertTrue(again.notices.any { "frame 1 is frame 0 again" in it }) { "${again.notices}" }
        refused("frames 0 and 1", "differ") { input(file("b.xyz", frame(box, 4.9) + frame(box, -4.9))) }
        for (other in listOf("10 0 0 0 10 0 0 0 12", "10 0 0 2 10 0 0 0 10")) {
            val moved = frame(other, 4.9).replace("-5 -5 -5", if ("12" in other) "-5 -5 -6" else "-5 -5 -5")
            refused("frames 0 and 1", "differ") { input(file("c.xyz", frame(box, 4.9) + moved)) }
        }
    }

    @Test
    fun `without ids particles are followed only where a format keeps their order and their number`() {
        val box = "Lattice=\"10 0 0 0 10 0 0 0 10\""
        fun xyz(k: Int, vararg x: Double) = "${x.size}\n$box Time=$k Properties=pos:R:3:map_shift:I:3\n" +
            x.joinToString("") { "$it 1 1 0 0 0\n" }
        assertTrue(input(file("a.xyz", xyz(0, 1.0, 2.0) + xyz(1, 1.0, 2.0))).snapshot(0).image != null)
        val fewer = input(file("b.xyz", xyz(0, 1.0, 2.0) + xyz(1, 2.0)))
        assertNull(fewer.snapshot(1).image)
        assertTrue(fewer.notices.any { "has no ids, and the number of particles changes" in it }) { "${fewer.notices}" }
        fun dump(k: Int, id: String, value: String) = "ITEM: TIME\n$k\nITEM: TIMESTEP\n$k\nITEM: NUMBER OF ATOMS\n1\n" +
            "ITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS ${id}xu yu zu\n${value}1 2 ${30 * k}\n"
        val silent = input(file("a.dump", dump(0, "", "") + dump(1, "", "")))
        assertNull(silent.snapshot(1).image)
        assertTrue(silent.notices.any { "has no ids, and LAMMPS changes the order" in it }) { "${silent.notices}" }
        val known = input(file("b.dump", dump(0, "id ", "7 ") + dump(1, "id ", "7 ")))
        assertEquals(3, known.snapshot(1).image!![2][0])
        assertTrue(known.notices.none { "no ids" in it }) { "${known.notices}" }
        assertTrue(input(file("c.dump", dump(0, "", ""))).notices.none { "no ids" in it })
    }

    @Test
    fun `spheres beyond a face that does not repeat are in the box and said`() {
        fun frame(k: Int, z: Double, faces: String) = "2\nLattice=\"9 0 0 0 9 0 0 0 9\" Time=$k pbc=\"$faces\" " +
            "Properties=id:I:1:pos:R:3:radius:R:1\n1 1 1 1 .5\n2 4 4 $z .5\n"
        val slab = input(file("a.xyz", frame(0, -3.0, "T T F") + frame(1, 12.0, "T T F")))
        for (k in 0..1) {
            val box = slab.state(k).boundary.box
            assertEquals(listOf(-8.0, 8.0), listOf(box.lower(2), box.upper(2)))
            assertEquals(9.0, box.length(0))
        }
        assertTrue(
            slab.notices.any {
                "particle 2 at z = -3.0 in frame 0 is outside the box" in it
            },
        ) { "${slab.notices}" }
        val inside = input(file("b.xyz", frame(0, 0.0, "T T F") + frame(1, 9.0, "T T F")))
        assertEquals(4.5, inside.state(1).boundary.box.upper(2))
        assertTrue(inside.notices.none { "outside" in it })
        // What has no box ends with the last state, as it does for a run in open space.
        val head = "2\nProperties=id:I:1:pos:R:3:radius:R:1 Time="
        val open = input(file("c.xyz", "${head}0\n1 1 1 1 .5\n2 4 4 9 .5\n${head}1\n1 1 1 1 .5\n2 4 4 4 .5\n"))
        assertEquals(4.5, open.state(0).boundary.box.upper(2))
        assertTrue(open.notices.any { "frame 0 are outside that around the last state" in it }) { "${open.notices}" }
    }

    @Test
    fun `frames of one time differ by parts of the box, and by velocities, radii and masses`() {
        fun frame(edge: Double, x: Double, of: String = "3 4 5 1e-8 2") =
            "2\nLattice=\"$edge 0 0 0 $edge 0 0 0 $edge\" Time=0 Properties=pos:R:3:velo:R:3:radius:R:1:mass:R:1\n" +
                "0 0 0 $of\n$x 0 0 0 0 0 1e-8 2\n"
        for (edge in listOf(1e-6, 10.0, 1e4)) {
            refused("differ") { input(file("a.xyz", frame(edge, 0.2 * edge) + frame(edge, 0.4 * edge))) }
            val again = input(file("b.xyz", frame(edge, 0.2 * edge) + frame(edge, (0.2 + 1e-8) * edge)))
            assertEquals(1, again.size)
        }
        for (other in listOf("3 4 6 1e-8 2", "3 4 5 2e-8 2", "3 4 5 1e-8 3", "0 0 0 1e-8 2")) {
            refused("differ") { input(file("c.xyz", frame(10.0, 1.0) + frame(10.0, 1.0, other))) }
            refused("differ") { input(file("d.xyz", frame(10.0, 1.0, other) + frame(10.0, 1.0))) }
        }
        assertEquals(1, input(file("e.xyz", frame(10.0, 1.0) + frame(10.0, 1.0, "3.000001 4 5 1e-8 2"))).size)
    }

    @Test
    fun `particles that come or go are said, and those that stay are followed`() {
        val new = input(file("a.xyz", row(0, "Time=0", 1.0) + row(1, "Time=1", 2.0, id = 8)))
        assertArrayEquals(intArrayOf(1), new.idsThroughout())
        assertTrue(new.notices.any { "particle 8 is at time 1.0 and not at time 0.0" in it }) { "${new.notices}" }
        val gone = "1\nLattice=\"9 0 0 0 9 0 0 0 9\" Time=1 Properties=id:I:1:pos:R:3:radius:R:1\n3 1 1 1 .1\n"
        val lost = input(file("b.xyz", row(0, "Time=0", 1.0) + gone))
        assertArrayEquals(intArrayOf(3), lost.idsThroughout())
        assertTrue(lost.notices.any { "particle 1 is at time 0.0 and not at time 1.0" in it }) { "${lost.notices}" }
    }

    /** A gas of temperature 1 in a box of edge 10 whose images slide at [rate], at [times]. */
    private fun sheared(rate: Double, times: List<Double>, axes: Pair<Int, Int> = 1 to 0): List<Snapshot> {
        val random = Random(3)
        val n = 400
        return times.mapIndexed { k, t ->
            val p = Array(3) { DoubleArray(n) { random.nextDouble() * 10 - 5 } }
            val v = Array(3) { DoubleArray(n) { random.nextGaussian() } }
            for (i in 0 until n) v[axes.second][i] += rate * p[axes.first][i]
            val raw = rate * 10 * t % 10
            snapshot(k.toLong(), t, p, v, offset = if (raw < 0) raw + 10 else raw, axes = axes)
        }
    }

    private fun temperature(input: AnalysisInput, k: Int): Double {
        val state = input.state(k)
        return VelocityMoments.of(state.population, state.boundary.meanFlow).temperature
    }

    @ParameterizedTest
    @CsvSource(
        "xyz,1.0,0.17,1,0", "lammps,1.0,0.17,1,0", "h5md,1.0,0.17,1,0", "lammps,-0.7,0.3,0,1", "h5md,-0.7,0.3,0,1",
        "xyz,-0.7,0.3,0,1", "lammps,1.0,1.0,1,0", "xyz,1.0,1.0,1,0", "h5md,1.0,1.0,1,0",
    )
    fun `a box that slides is known by how it leans and by the flow`(
        format: String,
        rate: Double,
        every: Double,
        normal: Int,
        slide: Int,
    ) {
        val states = sheared(rate, List(9) { it * every }, normal to slide)
        val input = input(export(format, states))
        val flow = input.state(0).boundary.meanFlow!!
        assertEquals(normal to slide, flow.normalAxis to flow.flowAxis)
        assertEquals(rate, flow.rate, 1e-9)
        assertEquals(1.0, temperature(input, 0), 0.1)
        assertTrue(input.notices.any { "images slide" in it && "scenario" in it }) { "${input.notices}" }
        for (k in states.indices) {
            val shear = input.state(k).boundary.shear!!
            val miss = shear.offset(states[k].time) - states[k].shearOffset
            assertEquals(0.0, Math.IEEEremainder(miss, 10.0), 1e-9)
            assertEquals(rate * 10, shear.velocity, 1e-8)
        }
    }

    @Test
    fun `of one state, or without times, the shear rate is about that of the velocities`() {
        val text = Files.readString(export("xyz", sheared(1.0, List(5) { it * 0.3 })))
        val timeless = file("a.xyz", text.replace(Regex("Time=\\S+"), ""))
        for (path in listOf(timeless, export("xyz", sheared(1.0, listOf(0.3))))) {
            val input = input(path)
            assertEquals(1.0, input.state(0).boundary.meanFlow!!.rate, 0.1)
            assertEquals(1.0, temperature(input, 0), 0.1)
            assertTrue(input.notices.any { "about" in it && "from the velocities" in it }) { "${input.notices}" }
        }
    }

    @Test
    fun `a box that leans and stands still has no flow, and one of a gas at rest is upright`() {
        val still = sheared(
            0.0,
            List(5) {
                it * 1.0
            },
        ).map { with(it) { snapshot(step, time, position, velocity, offset = 2.5) } }
        val input = input(export("lammps", still))
        assertNull(input.state(0).boundary.meanFlow)
        assertEquals(2.5, input.state(3).boundary.shear!!.offset(3.0), 1e-12)
        assertTrue(input.notices.any { "stand still" in it }) { "${input.notices}" }
        val gas = input(export("xyz", sheared(0.0, List(5) { it * 1.0 })))
        assertNull(gas.state(0).boundary.shear)
        assertEquals(emptyList<String>(), gas.notices)
    }

    @Test
    fun `a box that leans more and more slides, also where velocities do not tell how fast`() {
        fun without(states: List<Snapshot>) = file(
            "still.xyz",
            Files.readString(export("xyz", states)).lines().joinToString("\n") { line ->
                val words = line.split(' ')
                if ("Lattice" in
                    line
                ) {
                    line.replace(":velo:R:3", "")
                } else {
                    (words.take(4) + words.drop(7)).joinToString(" ")
                }
            },
        )
        val silent = input(without(sheared(0.3, List(5) { it * 0.5 })))
        assertFalse(silent.hasVelocities)
        assertEquals(0.3, silent.state(0).boundary.meanFlow!!.rate, 1e-9)
        assertTrue(silent.notices.any { "the slowest with which the box leans" in it }) { "${silent.notices}" }
        // Of two states, or no steady slide, nothing tells how fast; still nothing diffuses along it.
        for (times in listOf(listOf(0.0, 0.5), listOf(0.0, 0.5, 0.6, 3.9))) {
            val states = sheared(0.3, times).mapIndexed { k, it ->
                with(it) { snapshot(step, 0.5 * k, position, velocity, offset = shearOffset) }
            }
            val unknown = input(without(states))
            assertEquals(0.0, unknown.state(0).boundary.meanFlow!!.rate)
            assertEquals(0, unknown.state(0).boundary.meanFlow!!.flowAxis)
            assertTrue(unknown.notices.any { "nothing tells how fast" in it }) { "${unknown.notices}" }
            for ((k, s) in states.withIndex()) {
                assertEquals(s.shearOffset, unknown.state(k).boundary.shear!!.offset(s.time), 1e-12)
            }
        }
    }

    @Test
    fun `a cell that leans by more than a box is wrapped, and its places are not taken as unwrapped`() {
        val walk = walk(12, 0.5)
        val states = walk.mapIndexed { k, p ->
            val offset = 4.0 * k
            val y = DoubleArray(40) { Math.IEEEremainder(p[1][it], 10.0) }
            // Wrapped along the edges of the cell, as LAMMPS does it.
            val x = DoubleArray(40) { i ->
                val start = (y[i] / 10 + 0.5) * offset
                start + Math.IEEEremainder(p[0][i] - Math.rint(p[1][i] / 10) * offset - start, 10.0)
            }
            val z = DoubleArray(40) { Math.IEEEremainder(p[2][it], 10.0) }
            snapshot(k.toLong(), k.toDouble(), arrayOf(x, y, z), offset = offset)
        }
        for (word in listOf("xyz", "h5md", "lammps")) {
            val input = input(export(word, states))
            assertNull(input.snapshot(3).image) { word }
            assertTrue(input.notices.none { "unwrapped" in it }) { "${input.notices}" }
        }
    }

    @Test
    fun `a flow in a box that says nothing is doubted in words`() {
        val input = input(export("xyz", sheared(1.0, listOf(0.0))))
        assertNull(input.state(0).boundary.shear)
        assertTrue(
            input.notices.any {
                "velocities along x change by" in it && "scenario" in it
            },
        ) { "${input.notices}" }
        // Neither a slide by whole boxes nor any other steady one.
        val other = sheared(1.0, List(4) { it * 0.31 }).map { with(it) { snapshot(step, time, position, velocity) } }
        val upright = input(export("lammps", other))
        assertNull(upright.state(0).boundary.shear)
        assertTrue(upright.notices.any { "velocities along x change by" in it }) { "${upright.notices}" }
    }

    @Test
    fun `two ways to lean in one file are refused`() {
        val states = sheared(1.0, listOf(0.0, 0.2)) + sheared(1.0, listOf(0.4), 0 to 1)
        val later = states.mapIndexed { k, it ->
            if (k == 2) {
                with(it) {
                    snapshot(2, 0.4, position, velocity, offset = 4.0, axes = 0 to 1)
                }
            } else {
                it
            }
        }
        refused("frame 1", "frame 2", "one way") { input(export("xyz", later)) }
    }

    @Test
    fun `across a lean that stands still displacements count boxes along both edges`() {
        val before = snapshot(0, 0.0, Array(3) { doubleArrayOf(0.0, 1.0) }, offset = 2.5)
        val moved = Array(3) { a -> doubleArrayOf(if (a == 1) 8.0 else 0.0, 1.0) }
        val after = snapshot(1, 1.0, moved, offset = 2.5)
        val followed = Trajectories(listOf(Coordinate.Position(0), Coordinate.Position(1)), intArrayOf(1, 2))
        for (s in listOf(before, after)) followed.add(s.unwrapped().folded())
        assertArrayEquals(doubleArrayOf(-0.5, 0.5), followed.at(1, 0), 1e-12)
        assertArrayEquals(doubleArrayOf(3.5, -3.5), followed.at(1, 1), 1e-12)
    }

    @Test
    fun `a slab of LAMMPS repeats along x and y`() {
        val head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp mm\n0 10\n0 10\n0 10\n"
        val input = input(file("a.dump", "${head}ITEM: ATOMS id x y z radius\n1 1 1 2 .5\n2 9 1 7 .5\n"))
        val boundary = input.state(0).boundary
        assertEquals(listOf(true, true, false), (0..2).map { boundary.repeats(it) })
        assertEquals(10.0, boundary.box.length(0))
        assertEquals(6.0, boundary.box.length(2))
    }

    @Test
    fun `a scenario of another box is refused with both values`() {
        val scenario = BuiltIn.scenario("cooling-gas", listOf("box.lengths=[12,10,10]"))
        val path = export("xyz", sheared(0.0, listOf(0.0)))
        refused("box.lengths[0]", "is 12.0", "is 10.0 along x") { AnalysisInput.ofFile(path, scenario, "gas") }
        val right = BuiltIn.scenario("cooling-gas", listOf("box.lengths=[10,10,10]"))
        assertEquals(1, AnalysisInput.ofFile(path, right, "gas").size)
        val leaning = export("lammps", sheared(1.0, listOf(0.3)))
        refused("boundary", "do not slide", "leans by 3.0") { AnalysisInput.ofFile(leaning, right, "gas") }
    }

    @Test
    fun `images that are given a displacement have it, and the others what the flow makes`() {
        val box = Box.centred(10.0, 4.0, 1.0)
        val free = LeesEdwards(box, 0.5).shear
        assertEquals(3.0, free.offset(1.5))
        val given = ImageShear.at(box, LeesEdwards(box, 0.5).meanFlow, 7.25, 2.0)
        assertEquals(7.25, given.offset(2.0))
        assertEquals(0.25, given.offset(3.5), 1e-12)
        assertEquals(1.0, given.turns(3.5))
        assertNull(Periodic(box).shear)
    }
}
