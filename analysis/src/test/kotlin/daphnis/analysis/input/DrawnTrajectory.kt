package daphnis.analysis.input

import java.util.Random

/**
 * A trajectory that is known: what files of any format can hold of it, so that what is read can be held against it.
 *
 * @property kind what is drawn, in words
 */
internal class DrawnTrajectory(seed: Long) {
    private val random = Random(seed)

    fun <T> pick(vararg of: T): T = of[random.nextInt(of.size)]

    fun chance(percent: Int): Boolean = random.nextInt(100) < percent

    val count = pick(12, 20, 45)
    val frames = pick(1, 3, 7, 12)

    /** By axis; the faces of the others do not repeat. */
    val periodic: BooleanArray = pick("TTT", "TTT", "TTT", "TTF", "TFT", "FFF").let { s ->
        BooleanArray(3) {
            s[it] ==
                'T'
        }
    }

    /** Axes across and along which images slide, or null. */
    val axes: Pair<Int, Int>? = if (periodic.all { it } && chance(40)) pick(1 to 0, 2 to 0, 2 to 1, 0 to 1) else null
    val rate: Double = if (axes == null || chance(25)) 0.0 else pick(1.0, -0.7, 0.3)

    /** A lean that stands still. */
    private val lean = if (axes != null && rate == 0.0) pick(2.5, -1.5, 6.0) else 0.0
    private val grows = rate == 0.0 && chance(40)
    val every: Double = pick(0.1, 0.25, 1.0, 2.3, 20.0)

    /** Whether the displacement of images goes on beyond a box. */
    private val goesOn = chance(30)

    /** Velocities around the flow. */
    val thermal: Double = pick(0.05, 0.2, 1.0)
    val firstStep: Long = pick(0L, 0L, 700L)
    private val edges = doubleArrayOf(10.0, pick(10.0, 14.0), pick(10.0, 12.0))
    private val corner = DoubleArray(3) { pick(0.0, 0.0, -5.0, 3.25, 105.0, -41.5) }
    private val moves = chance(20)

    /** How far places go in a frame, in parts of the shortest edge. */
    private val reach = pick(0.02, 0.1, 0.6)
    val id: IntArray = (1..3 * count).shuffled(random).take(count).sorted().toIntArray()
    val radius = DoubleArray(count) { 0.05 + 0.2 * random.nextDouble() }
    val mass = DoubleArray(count) { 0.5 + random.nextDouble() }

    /** Without a box, from its centre, `[frame][axis][k]`. */
    val place: List<Array<DoubleArray>>
    val velocity: List<Array<DoubleArray>>

    init {
        val at = Array(3) { a -> DoubleArray(count) { (random.nextDouble() - 0.5) * edges[a] } }
        place = List(frames) { t ->
            for (axis in 0..2) {
                for (k in 0 until count) {
                    val next = at[axis][k] + if (t == 0) 0.0 else reach * 10 * random.nextGaussian()
                    // Where nothing repeats, spheres stay between the faces.
                    at[axis][k] =
                        if (periodic[axis]) next else next.coerceIn(-edges[axis] / 2 + 0.3, edges[axis] / 2 - 0.3)
                }
            }
            Array(3) { at[it].copyOf() }
        }
        velocity = List(frames) { t ->
            val boxed = wrapped(t).first
            Array(3) { axis ->
                DoubleArray(count) { k ->
                    val flow = if (axes != null && axis == axes.second) rate * boxed[axes.first][k] else 0.0
                    random.nextGaussian() * thermal + flow
                }
            }
        }
    }

    fun step(t: Int): Long = firstStep + 10L * t

    fun time(t: Int): Double = step(t) / 10 * every

    fun edge(t: Int, axis: Int): Double = edges[axis] * if (grows && periodic[axis]) 1 + 0.05 * t else 1.0

    /** The lower corner of the box as files have it. */
    fun corner(t: Int, axis: Int): Double = corner[axis] + if (moves) 0.7 * t else 0.0

    /** By how much the image one box up is displaced, reduced as LAMMPS does it. */
    fun offset(t: Int): Double {
        val (normal, slide) = axes ?: return 0.0
        val length = edge(t, slide)
        val raw = lean + rate * edge(t, normal) * time(t)
        return if (rate == 0.0 || goesOn) raw else raw - length * Math.rint(raw / length)
    }

    /** Edges by row. */
    fun cell(t: Int): Array<DoubleArray> = Array(3) { row ->
        DoubleArray(3) { axis ->
            if (row == axis) {
                edge(t, row)
            } else if (axes == row to axis) {
                offset(t)
            } else {
                0.0
            }
        }
    }

    /** Places in the cell, which leans, from its centre, and the boxes that brings them back. */
    fun wrapped(t: Int): Pair<Array<DoubleArray>, Array<IntArray>> {
        val places = Array(3) { place[t][it].copyOf() }
        val boxes = Array(3) { IntArray(count) }
        val cell = cell(t)
        val order = listOfNotNull(axes?.first) + (0..2).filter { it != axes?.first }
        for (axis in order) {
            if (!periodic[axis]) continue
            for (k in 0 until count) {
                val start = if (axes != null && axis == axes.second) {
                    places[axes.first][k] / edge(t, axes.first) * offset(t)
                } else {
                    0.0
                }
                val n = Math.floor((places[axis][k] - start) / edge(t, axis) + 0.5)
                for (c in 0..2) places[c][k] -= n * cell[axis][c]
                boxes[axis][k] = n.toInt()
            }
        }
        return places to boxes
    }

    /** What a coordinate from the centre is in a file. */
    fun inFile(t: Int, axis: Int, fromCentre: Double): Double {
        val (normal, slide) = axes ?: (-1 to -1)
        val middle = corner(t, axis) + edge(t, axis) / 2 + if (axis == slide) offset(t) / 2 else 0.0
        check(normal != axis || axis != slide)
        return fromCentre + middle
    }

    fun shuffled(): List<Int> = (0 until count).shuffled(random)

    val kind: String
        get() = "$count in $frames frames, ${periodic.asList()}, slide $axes at $rate, grows $grows, corner " +
            "${corner.asList()}${if (moves) " moving" else ""}, reach $reach, every $every"
}
