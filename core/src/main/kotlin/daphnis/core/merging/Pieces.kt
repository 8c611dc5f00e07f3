package daphnis.core.merging

import daphnis.core.population.Bonds
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.nextId
import daphnis.core.random.CounterRandom
import kotlin.math.PI
import kotlin.math.max
import kotlin.math.sqrt
import kotlin.math.withSign

/** Puts pieces in the places of the spheres that have broken in a step, at its end. */
internal class Pieces(private val rule: BreakRule) {
    private val random = CounterRandom(rule.seed)
    private val half = rule.pieces / 2
    private val isOdd = rule.pieces % 2 == 1

    /** From the centre, of one of each opposite pair, in axes of which the third is drawn. */
    private val from = DoubleArray(3 * half).also { place ->
        for (k in 0 until half) {
            val z = (k + 0.5) / half
            val angle = GOLDEN_ANGLE * k
            place[3 * k] = sqrt(1 - z * z) * StrictMath.cos(angle)
            place[3 * k + 1] = sqrt(1 - z * z) * StrictMath.sin(angle)
            place[3 * k + 2] = z
        }
    }
    private val axes = Array(3) { DoubleArray(3) }

    /**
     * Breaks what is marked in [population] after the step from time [start]. One piece keeps the id, the others have the
     * next ones above all that are there, in the order of the spheres that have broken, on whichever node they are.
     *
     * @return how many spheres have broken here
     * @throws IllegalArgumentException when there are no more ids
     */
    fun scatter(population: Population, partition: Partition, start: Double): Int {
        val broken = (0 until population.size).filter { population.bonds[it].isNotEmpty() }.toIntArray()
        val all = partition.gather(IntArray(broken.size) { population.id[broken[it]] })
        if (all.isEmpty()) return 0
        all.sort()
        val more = rule.pieces - 1
        val next = partition.nextId(population, all.size.toLong() * more)
        val pieces = PopulationColumns.picked(population, IntArray(broken.size * more) { broken[it / more] })
        for (k in pieces.id.indices) {
            pieces.id[k] = next + all.binarySearch(pieces.id[k]) * more + k % more
            pieces.bonds[k] = Bonds.FREE
        }
        val size = population.size
        population.join(pieces, IntArray(all.size * more) { next + it })
        for ((n, k) in broken.withIndex()) {
            population.bonds[k] = Bonds.FREE
            random.draw(population.id[k], start, 0)
            drawAxes()
            place(population, k, size + n * more)
        }
        return broken.size
    }

    /** Draws the third axis, uniformly over all directions. */
    private fun drawAxes() {
        val z = 2 * random.uniform(0) - 1
        val angle = 2 * PI * random.uniform(1)
        val s = sqrt(max(0.0, 1 - z * z))
        val x = s * StrictMath.cos(angle)
        val y = s * StrictMath.sin(angle)
        // Without a branch that fails near an axis (Duff et al. 2017, J. Comput. Graph. Tech. 6, 1).
        val sign = 1.0.withSign(z)
        val a = -1 / (sign + z)
        val b = x * y * a
        axes[0][0] = 1 + sign * x * x * a
        axes[0][1] = sign * b
        axes[0][2] = -sign * x
        axes[1][0] = b
        axes[1][1] = sign + y * y * a
        axes[1][2] = -y
        axes[2][0] = x
        axes[2][1] = y
        axes[2][2] = z
    }

    /** Pieces of the sphere at index [k] are there and, all but one, at [others] and following. */
    private fun place(p: Population, k: Int, others: Int) {
        val radius = p.radius[k] * rule.ratio
        val away = p.radius[k] - radius
        val mass = p.mass[k] / rule.pieces
        val centre = DoubleArray(6) { p.column(it)[k] }
        var next = others
        for (pair in 0 until half) {
            put(p, if (pair == 0 && !isOdd) k else next++, centre, pair, away, rule.spread)
            put(p, next++, centre, pair, -away, -rule.spread)
        }
        p.radius[k] = radius
        p.mass[k] = mass
        for (piece in others until others + rule.pieces - 1) {
            p.radius[piece] = radius
            p.mass[piece] = mass
        }
    }

    private fun put(p: Population, piece: Int, centre: DoubleArray, pair: Int, away: Double, speed: Double) {
        for (axis in 0..2) {
            val along =
                from[3 * pair] * axes[0][axis] + from[3 * pair + 1] * axes[1][axis] + from[3 * pair + 2] * axes[2][axis]
            p.column(SphereQuantity.POSITION.place + axis)[piece] = centre[axis] + away * along + 0.0
            p.column(SphereQuantity.VELOCITY.place + axis)[piece] = centre[3 + axis] + speed * along + 0.0
        }
    }

    companion object {
        /** In the list of a sphere's partners, with itself: it has broken in this step. */
        const val BROKEN: Int = 1

        /** π (3 − √5). */
        private const val GOLDEN_ANGLE = 2.399963229728653
    }
}
