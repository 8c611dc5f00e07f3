package daphnis.analysis.diffusion

import daphnis.core.format.Snapshot
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.floor
import kotlin.math.sin
import kotlin.math.sqrt

/** Random walks of D = 0.5 that are carried along by the edges of a box that breathes, as a barostat lets it. */
class ChangingBoxTest {
    private fun walk(edge: (Int, SeededRandom) -> Double): MeanSquareDisplacement {
        val random = SeededRandom(2)
        val positions = listOf(Coordinate.Position(0), Coordinate.Position(1), Coordinate.Position(2))
        val trajectories = Trajectories(positions, IntArray(COUNT) { it })
        val place = Array(3) { DoubleArray(COUNT) { random.nextDouble() } }
        for (t in 0 until TIMES) {
            val length = edge(t, random)
            if (t > 0) for (s in place) for (k in s.indices) s[k] += random.nextGaussian() * sqrt(STEP) / length
            val image = Array(3) { axis -> IntArray(COUNT) { floor(place[axis][it]).toInt() } }
            val position = Array(3) { axis ->
                DoubleArray(COUNT) { (place[axis][it] - image[axis][it] - 0.5) * length }
            }
            trajectories.add(
                Snapshot(
                    t.toLong(), t * STEP, DoubleArray(3) { length }, BooleanArray(3) { true }, 0.0,
                    IntArray(COUNT) { it }, position, Array(3) { DoubleArray(COUNT) }, DoubleArray(COUNT) { 0.1 },
                    DoubleArray(COUNT) { 1.0 }, image = image,
                ),
            )
        }
        return MeanSquareDisplacement(trajectories)
    }

    @Test
    fun `what moves with the edges is no displacement, whether they are noise, swing or grow`() {
        val boxes = listOf<Pair<String, (Int, SeededRandom) -> Double>>(
            "fixed" to { _, _ -> 10.0 },
            "noise of 3 %" to { _, r -> 10 * (1 + 0.03 * r.nextGaussian()) },
            "noise of 10 %" to { _, r -> 10 * (1 + 0.1 * r.nextGaussian()) },
            "a sine of 5 %" to { t, _ -> 10 * (1 + 0.05 * sin(2 * PI * t / 37)) },
            "half as long again" to { t, _ -> 10 * (1 + 0.5 * t / TIMES) },
        )
        for ((name, edge) in boxes) {
            val found = walk(edge)
            for (axis in 0..2) assertEquals(1.0, found.mean(axis)[1], 0.03, name)
            assertEquals(0.5, found.diffusion(0, 1, 2)!!.value, 0.025, name)
        }
    }

    private companion object {
        const val COUNT = 300
        const val TIMES = 400
        const val STEP = 0.5
    }
}
