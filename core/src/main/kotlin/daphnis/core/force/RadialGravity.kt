package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.mesh.BatchTransform
import daphnis.core.force.mesh.ComplexRows
import daphnis.core.force.mesh.CubicSpline
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Partition
import daphnis.core.population.Partitioned
import daphnis.core.population.Population
import daphnis.core.population.SphereSum
import kotlin.math.floor

/**
 * Gravity along x alone, of a flat ring that is the same all along y: Σ over waves of the surface density, each with
 * the potential −2πG Σ_k/|k| of a thin sheet (Toomre 1964, ApJ 139, 1217), as in patches of kilometres that are thin
 * along the orbit (Lehmann, Schmidt & Salo 2017, ApJ 851, 125). For a box that repeats along x. Nothing pulls along y
 * and z.
 *
 * Masses are spread over a line of [POINTS_PER_WAVE] points per shortest wave in whole numbers, whose sums have the
 * same bits in any order and on any number of threads. Spreading costs the shortest wave some 2e-4 of its force.
 *
 * @param constant G, length³/(mass · time²)
 * @param modes the waves L_x, L_x/2, … L_x/[modes] are summed; shorter ones pull nothing
 * @throws IllegalArgumentException when the box does not repeat along x or is endless along y, or a number is out of
 *   range
 */
public class RadialGravity(
    private val boundary: BoundaryConditions,
    public val constant: Double,
    public val modes: Int,
) : MutualGravity,
    Partitioned {
    override var partition: Partition = Partition.Whole
    private var loop: RangeLoop = InlineLoop
    private val sum = SphereSum()

    /** Along x; those along y and z stay 0. */
    private val last = Accelerations()

    private val points: Int
    private val transform: BatchTransform
    private val corrections: DoubleArray
    private val rows = ComplexRows()
    private val spare = ComplexRows()
    private var masses = arrayOf<LongArray>()
    private val wholes: DoubleArray
    private val count = DoubleArray(1)
    private val heaviest = DoubleArray(1)

    /** Minus the potential at the points of the line. */
    private var line = DoubleArray(0)
    private var potential = DoubleArray(0)

    init {
        require(constant >= 0 && constant.isFinite()) { "G is $constant; it must be at least 0" }
        require(modes in 1..MOST_MODES) { "modes is $modes; it must be in 1..$MOST_MODES" }
        require(fits(boundary)) { "radial gravity needs a box that repeats along x and has a length along y" }
        points = BatchTransform.lengthFrom(POINTS_PER_WAVE.toDouble() * modes)
        transform = BatchTransform(points)
        wholes = DoubleArray(points)
        corrections = DoubleArray(modes + 1) { CubicSpline.correction(2 * Math.PI * it / points) }
    }

    /** Infinite: waves know no end. */
    override val range: Double get() = Double.POSITIVE_INFINITY

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    override fun kick(population: Population, time: Double, duration: Double) {
        evaluate(population, time)
        val ax = last.x
        loop.run(population.size) { _, from, to ->
            for (k in from until to) population.vx[k] += ax[k] * duration
        }
    }

    override fun accelerations(population: Population, time: Double): Array<DoubleArray> {
        evaluate(population, time)
        return arrayOf(last.x, last.y, last.z)
    }

    /** 0: what pulls along x alone carries no y momentum. */
    override fun stressXY(population: Population, time: Double): Double = 0.0

    /** ½ Σ m Φ, with the potential of the waves, whose mean is 0. */
    override fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double {
        evaluate(population, time)
        return sum.of(population, partition) { k -> 0.5 * population.mass[k] * potential[k] }
    }

    private fun evaluate(population: Population, time: Double) {
        if (last.areOf(population, time, partition)) return
        last.begin(population.size)
        if (potential.size < population.size) potential = DoubleArray(population.size)
        if (masses.size < loop.workers) masses = Array(loop.workers) { LongArray(points) }
        spread(population)
        transformLine()
        read(population)
        last.keep(population, time)
    }

    private fun spread(p: Population) {
        for (own in masses) own.fill(0)
        val unit = unit(p)
        val per = 1 / unit
        loop.run(p.size) { worker, from, to ->
            val own = masses[worker]
            val w = DoubleArray(CubicSpline.POINTS)
            for (k in from until to) {
                val first = weigh(p.x[k], w)
                for (a in 0 until CubicSpline.POINTS) {
                    own[wrap(first + a)] += Math.rint(w[a] * p.mass[k] * per).toLong()
                }
            }
        }
        for (q in 0 until points) {
            var whole = 0L
            for (own in masses) whole += own[q]
            wholes[q] = whole.toDouble()
        }
        partition.add(wholes)
        rows.ensure(points)
        for (q in 0 until points) {
            rows.re[q] = wholes[q] * unit
            rows.im[q] = 0.0
        }
    }

    /** What a whole number stands for: a power of two, so that all masses on one point still fit. */
    private fun unit(p: Population): Double {
        count[0] = p.size.toDouble()
        partition.add(count)
        heaviest[0] = java.lang.Double.MIN_NORMAL
        for (k in 0 until p.size) heaviest[0] = Math.max(heaviest[0], p.mass[k])
        partition.max(heaviest)
        return Math.scalb(1.0, Math.getExponent(heaviest[0]) + 1 + Math.getExponent(count[0] + 1) + 1 - BITS)
    }

    /** Writes the weights of a sphere at [x] to [w]; returns the first of its points. */
    private fun weigh(x: Double, w: DoubleArray): Int {
        val place = (x - boundary.box.lowerX) / boundary.box.length(0) * points
        val point = floor(place)
        CubicSpline.weights(place - point, w, 0)
        return point.toInt() - 1
    }

    private fun wrap(point: Int): Int = if (point >= 0 && point < points) point else Math.floorMod(point, points)

    private fun transformLine() {
        val waves = transform.forward(rows, spare, 1)
        val area = boundary.box.length(0) * boundary.box.length(1)
        val re = waves.re
        val im = waves.im
        re[0] = 0.0
        im[0] = 0.0
        for (m in 1..points / 2) {
            val k = 2 * Math.PI * m / boundary.box.length(0)
            val weight = if (m <= modes) 2 * Math.PI / (k * area) * corrections[m] else 0.0
            re[m] *= weight
            im[m] *= weight
            if (m < points - m) {
                re[points - m] *= weight
                im[points - m] *= weight
            }
        }
        val back = transform.backward(waves, if (waves === rows) spare else rows, 1)
        if (line.size != points) line = DoubleArray(points)
        back.re.copyInto(line, 0, 0, points)
    }

    private fun read(p: Population) {
        val perPoint = points / boundary.box.length(0)
        val ax = last.x
        loop.run(p.size) { _, from, to ->
            val w = DoubleArray(CubicSpline.POINTS)
            val g = DoubleArray(CubicSpline.POINTS)
            for (k in from until to) {
                val place = (p.x[k] - boundary.box.lowerX) / boundary.box.length(0) * points
                val first = weigh(p.x[k], w)
                CubicSpline.slopes(place - floor(place), g, 0)
                var value = 0.0
                var slope = 0.0
                for (a in 0 until CubicSpline.POINTS) {
                    val v = line[wrap(first + a)]
                    value += w[a] * v
                    slope += g[a] * v
                }
                ax[k] = constant * slope * perPoint
                potential[k] = -constant * value
            }
        }
    }

    public companion object {
        /** The most waves. */
        public const val MOST_MODES: Int = 4096

        private const val POINTS_PER_WAVE = 16

        /** Of a whole number, so that sums of them are exact as a [Double] too. */
        private const val BITS = 52

        /** Whether the box repeats along x and has a length along y. */
        @JvmStatic
        public fun fits(boundary: BoundaryConditions): Boolean =
            boundary.hasImages(0) && boundary.box.length(1).isFinite()
    }
}
