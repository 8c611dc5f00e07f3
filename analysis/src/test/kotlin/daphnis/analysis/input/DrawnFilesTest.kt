package daphnis.analysis.input

import daphnis.analysis.diffusion.Coordinate
import daphnis.analysis.diffusion.Trajectories
import daphnis.analysis.input.DrawnFiles.Places
import daphnis.core.engine.Draws
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** What is read of files that are drawn is what was written. */
class DrawnFilesTest {
    @TempDir
    lateinit var home: Path

    @Test
    fun `what is read is what was written, in every format and form`() {
        val wrong = ArrayList<String>()
        for (seed in Draws.first until Draws.first + Draws.share(250, 20_000)) {
            val trajectory = DrawnTrajectory(seed)
            val (path, says) = DrawnFiles(trajectory, home).draw()
            try {
                compare(trajectory, says, AnalysisInput.ofFile(path, null, ""))
            } catch (e: Throwable) {
                wrong += "seed $seed: ${says.words}; ${trajectory.kind}: ${e.message}"
            }
        }
        assertEquals(emptyList<String>(), wrong)
    }

    private fun compare(t: DrawnTrajectory, says: DrawnFiles.Says, input: AnalysisInput) {
        assertEquals(says.frames.size, input.size)
        assertEquals(says.hasTime || t.frames == 1, input.hasTimes) { "times" }
        assertEquals(says.hasVelocity, input.hasVelocities) { "velocities" }
        assertArrayEquals(t.id, input.idsThroughout())
        for ((k, f) in says.frames.withIndex()) frame(t, says, f, input, k)
        slide(t, says, input)
        displacements(t, says, input)
    }

    private fun frame(t: DrawnTrajectory, says: DrawnFiles.Says, f: Int, input: AnalysisInput, k: Int) {
        assertEquals(if (says.hasTime) t.time(f) else t.step(f).toDouble(), input.times[k], 1e-12)
        val state = input.state(k)
        val snapshot = input.snapshot(k)
        assertArrayEquals(t.id, snapshot.id)
        assertEquals(says.hasRadius to says.hasMass, snapshot.hasRadius to snapshot.hasMass)
        val p = state.population
        if (says.hasRadius) assertArrayEquals(t.radius, p.radius, 1e-15)
        if (says.hasMass) assertArrayEquals(t.mass, p.mass, 1e-15)
        val box = state.boundary.box
        val isOpen = (0..2).all { snapshot.lengths[it].isNaN() }
        for (axis in 0..2) {
            assertEquals(t.periodic[axis], state.boundary.repeats(axis)) { "faces of $axis" }
            if (t.periodic[axis]) assertEquals(t.edge(f, axis), box.length(axis), 1e-9) { "edge $axis of frame $f" }
            if (says.hasVelocity) assertArrayEquals(t.velocity[f][axis], snapshot.velocity[axis], 1e-12)
            val isInside = p.position(axis).all { it in box.lower(axis)..box.upper(axis) }
            for (x in p.position(axis)) {
                if (isOpen) {
                    assertTrue(isInside || input.notices.any { "that around the last state" in it })
                } else {
                    assertTrue(x in box.lower(axis)..box.upper(axis)) { "frame $f: $x is outside along $axis" }
                }
            }
        }
        // Distances do not depend on where the box begins.
        val miss = DoubleArray(3)
        for (i in 1 until t.count) {
            for (a in 0..2) {
                miss[a] = p.position(a)[i] - p.position(a)[0] - (t.place[f][a][i] - t.place[f][a][0])
            }
            for (axis in listOfNotNull(t.axes?.first) + (0..2)) {
                if (!t.periodic[axis]) continue
                val n = Math.rint(miss[axis] / t.edge(f, axis))
                for (a in 0..2) miss[a] -= n * t.cell(f)[axis][a]
            }
            assertArrayEquals(DoubleArray(3), miss, 1e-8) { "frame $f, particle ${t.id[i]}" }
        }
    }

    private fun slide(t: DrawnTrajectory, says: DrawnFiles.Says, input: AnalysisInput) {
        val flow = input.state(0).boundary.meanFlow
        if (t.axes == null) {
            assertEquals(null, input.state(0).boundary.shear?.let { it.normalAxis to it.slideAxis }) { "shear" }
            return
        }
        for ((k, f) in says.frames.withIndex()) {
            val length = t.edge(f, t.axes.second)
            val shear = input.state(k).boundary.shear
            val offset = shear?.offset(input.times[k]) ?: 0.0
            assertEquals(0.0, Math.IEEEremainder(offset - t.offset(f), length), 1e-7) { "offset of frame $f" }
        }
        val leans = (0 until t.frames).map { Math.IEEEremainder(t.offset(it) - t.offset(0), t.edge(0, t.axes.second)) }
        if (leans.any { Math.abs(it) > 0.2 }) {
            assertNotNull(flow) { "flow, ${input.notices}" }
            assertTrue(input.notices.none { "stand still" in it }) { "${input.notices}" }
        }
        if (says.hasVelocity && flow != null && says.hasTime && t.frames > 2) {
            val isAbout = input.notices.any { "taken as about" in it }
            if (input.notices.any { "nothing tells how fast" in it }) return
            val error = t.thermal / 3 / Math.sqrt(t.count.toDouble())
            assertEquals(t.rate, flow.rate, if (isAbout) 5 * error else 1e-6) { "rate" }
        }
    }

    private fun displacements(t: DrawnTrajectory, says: DrawnFiles.Says, input: AnalysisInput) {
        val axes = (0..2).filter { t.periodic[it] && (t.axes?.second != it || t.rate == 0.0) }
        if (axes.isEmpty()) return
        // Only a dump says itself that places go on beyond the box; nothing is better than what is wrong.
        val isTold =
            says.places == Places.WITH_IMAGES || says.places == Places.UNWRAPPED && says.words.startsWith("dump")
        if (!isTold && input.snapshot(0).image == null) return
        val followed = Trajectories(axes.map { Coordinate.Position(it) }, input.idsThroughout())
        for (k in 0 until t.frames) {
            assertNotNull(input.snapshot(k).image) { "images of frame $k" }
            followed.add(input.snapshot(k))
        }
        val mass = input.snapshot(0).mass
        for ((c, axis) in axes.withIndex()) {
            fun relative(f: Int) = t.place[f][axis].let { x ->
                val mean = x.indices.sumOf { x[it] * mass[it] } / mass.sum()
                DoubleArray(t.count) { (x[it] - mean) / t.edge(f, axis) }
            }
            // What moves with the edges of a box is no displacement.
            val moved = DoubleArray(t.count)
            for (k in 0 until t.frames) {
                if (k > 0) {
                    val edge = (t.edge(k - 1, axis) + t.edge(k, axis)) / 2
                    val (before, now) = relative(k - 1) to relative(k)
                    for (i in moved.indices) moved[i] += (now[i] - before[i]) * edge
                }
                val read = DoubleArray(t.count) { followed.at(k, c)[it] - followed.at(0, c)[it] }
                assertArrayEquals(moved, read, 1e-7) { "displacement along $axis to frame $k" }
            }
        }
    }
}
