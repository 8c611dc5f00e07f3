package daphnis.core.compression

import daphnis.core.Engines
import daphnis.core.boundary.Box
import daphnis.core.engine.CollisionEngine
import daphnis.core.initial.Placement
import daphnis.core.initial.PlacementException
import daphnis.core.initial.PlacementProgress
import daphnis.core.initial.Positions
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.initial.fillingFactor
import java.util.Locale
import kotlin.math.sqrt

/**
 * Random places of any density up to jamming: spheres so small that they fill a fifth of the box are placed at random,
 * and then all grow in proportion to their radii while they collide elastically ([GrowingSpheres], with its
 * thermostat), the slower the denser they are. Spheres that fill less than a fifth are placed at random and do not
 * move.
 *
 * The state is near equilibrium, not in it: at the filling factor 0.5 the pressure is 11 % above that of Carnahan &
 * Starling at first, and within 1 % of it after two diameters over the thermal speed.
 *
 * The same bits for any number of threads. Equal spheres jam at about 0.64, and discs crystallize.
 *
 * Who watches ([PlacementProgress]) is told how far they have grown.
 *
 * @param threads threads to compute on, the caller's included
 */
public class GrownPlacement internal constructor(private val threads: Int, private val mostWork: Int) : Placement {
    @JvmOverloads
    public constructor(threads: Int = 1) : this(threads, MOST_WORK)

    /**
     * @throws PlacementException also for walls, and when spheres jam before they have their radii, or cannot have them
     */
    override fun place(radii: DoubleArray, box: Box, walled: BooleanArray, random: SeededRandom): Positions {
        check(radii, box, walled)
        val filling = fillingFactor(radii, box)
        val part = if (filling <= LOOSE) 1.0 else scale(LOOSE / filling, box)
        val small = DoubleArray(radii.size) { radii[it] * part }
        val start = RandomPlacement(threads = threads).place(small, box, walled, random)
        return if (part == 1.0) start else grown(start, radii, part, box, random)
    }

    /**
     * Places spheres with these [radii] times one factor at which the reduced pressure P V/(N kT) is [pressure] as they
     * grow, on average over the last five collisions of each. From four fifths of it on they grow by a five-hundredth
     * in the time in which one flies a mean diameter: up to the freezing of equal spheres, the pressure is that of
     * equilibrium within some percent.
     *
     * @throws PlacementException also when there are fewer than two, and when they jam or touch their own images before
     */
    public fun placeAtPressure(
        pressure: Double,
        radii: DoubleArray,
        box: Box,
        walled: BooleanArray,
        random: SeededRandom,
    ): GrownSpheres {
        require(pressure > 1 && pressure < GrowingGas.JAMMED) {
            "the reduced pressure is $pressure; it must be > 1 and < ${GrowingGas.JAMMED}"
        }
        requireRepeats(box, walled)
        if (radii.size < 2) throw PlacementException("${radii.size} have no pressure; it takes two")
        val loose = looseFor(pressure, radii, box)
        // Whatever the radii are, times are those of spheres that fill a half.
        val half = scale(HALF / fillingFactor(radii, box), box)
        val wide = DoubleArray(radii.size) { radii[it] * half }
        val start = RandomPlacement(threads = threads)
            .place(DoubleArray(radii.size) { radii[it] * loose }, box, walled, random)
        val gas = GrowingGas.of(start, wide, loose / half, box, random)
        return Engines.horizon(threads).use { engine ->
            val factor = loose * growTo(pressure, gas, box, engine)
            GrownSpheres(gas.places(), factor / ROOM)
        }
    }

    private fun growTo(pressure: Double, gas: GrowingGas, box: Box, engine: CollisionEngine): Double {
        val n = gas.spheres.size
        val few = minOf(1.0, n / FEW)
        val window = PressureWindow(WINDOW * n / few)
        var factor = 1.0
        while (!(window.isFull && window.mean >= pressure)) {
            val isNear = window.isFull && window.mean > NEAR * pressure
            val filling = fillingFactor(gas.spheres.radius, box)
            val above = if (window.isFull) window.mean - 1 else 2 * filling
            val fast = STAGES.firstOrNull { filling < it.filling(box) }?.rate ?: SLOWEST
            val rate = few * if (isNear) SLOWEST else minOf(fast, PER_WINDOW * above)
            val end = if (isNear) pressure else NEAR * pressure
            var last = 0L
            factor *=
                gas.grow(engine, 1 + PIECE, rate, mostWork, "the reduced pressure $pressure") { growing, all, growth ->
                    window.add(growing.reducedPressure, growth, all - last)
                    last = all
                    PlacementProgress.tell(Double.NaN) {
                        line("%s %.4g, reduced pressure %.4g of %.4g", growing, gas, window.mean, pressure)
                    }
                    window.isFull && window.mean >= end
                }
        }
        return factor
    }

    /** The factor of [radii] from which growth to [pressure] begins: well below it. */
    internal fun looseFor(pressure: Double, radii: DoubleArray, box: Box): Double =
        scale(minOf(LOOSE, (pressure - 1) * PER_PRESSURE) / fillingFactor(radii, box), box)

    /** All in the middle, which costs nothing; checks what can be known without growth. */
    internal fun middle(radii: DoubleArray, box: Box, walled: BooleanArray): Positions {
        check(radii, box, walled)
        return middle(radii.size)
    }

    internal fun middle(count: Int): Positions = Positions(DoubleArray(count), DoubleArray(count), DoubleArray(count))

    private fun requireRepeats(box: Box, walled: BooleanArray) {
        if ((0 until box.space.dimensions).none { walled[it] }) return
        throw PlacementException("spheres grow in a box that repeats along all axes only")
    }

    private fun check(radii: DoubleArray, box: Box, walled: BooleanArray) {
        requireRepeats(box, walled)
        if (radii.isEmpty()) return
        val largest = radii.max()
        for (axis in 0 until box.space.dimensions) {
            if (2 * largest * ROOM < box.length(axis)) continue
            throw PlacementException("a sphere of radius $largest touches its own image along ${"xyz"[axis]}")
        }
        val filling = fillingFactor(radii, box)
        val what = if (box.space.isPlane) "discs" else "spheres"
        val equal = radii.all { it == largest }
        val most = if (equal) box.space.closestPacking else 1.0
        if (filling >= most) {
            throw PlacementException("the filling factor would be $filling; $what fill $most at most")
        }
        val reached = if (box.space.isPlane) MOST_DISCS else MOST_SPHERES
        if (equal && filling > reached) {
            throw PlacementException(
                "the filling factor would be $filling; equal $what that grow jam at $reached or before; " +
                    "use a lattice above that",
            )
        }
    }

    /**
     * Where spheres are when they have grown to [radii] from places [start], where they do not overlap with the [part]
     * of these. The unit of time is that in which a sphere flies a mean diameter, at the speed of a component.
     *
     * @throws PlacementException when they jam before
     */
    internal fun grown(start: Positions, radii: DoubleArray, part: Double, box: Box, random: SeededRandom): Positions {
        val gas = GrowingGas.of(start, radii, part, box, random)
        val full = fillingFactor(radii, box)
        val goals = STAGES.map { if (full <= it.filling(box)) ROOM else scale(it.filling(box) / full, box) } + ROOM
        val rates = STAGES.map { it.rate } + SLOWEST
        // In units of time, of which there are more the slower spheres grow.
        val all = goals.indices.map { k ->
            val from = if (k == 0) part else maxOf(part, goals[k - 1])
            maxOf(0.0, goals[k] / from - 1) / rates[k]
        }
        Engines.horizon(threads).use { engine ->
            var now = part
            for ((k, goal) in goals.withIndex()) {
                // A hair more than asked for, so that none overlap with the radii that are.
                if (goal <= now) continue
                val before = all.take(k).sum()
                var grown = 1.0
                gas.grow(engine, goal / now, rates[k], mostWork, "$full") { growing, _, growth ->
                    grown += growth
                    PlacementProgress.tell((before + (grown - 1) / rates[k]) / all.sum()) {
                        line("%s %.4g of %.4g", growing, gas, full)
                    }
                    false
                }
                now = goal
            }
        }
        return gas.places()
    }

    private fun line(format: String, growing: GrowingSpheres, gas: GrowingGas, vararg numbers: Any): String {
        val what = if (growing.space.isPlane) "discs grow: area fraction" else "spheres grow: filling factor"
        return String.format(Locale.ROOT, format, what, growing.fillingFactor(gas.spheres), *numbers)
    }

    /** Up to [filling] radii grow by [rate] of what they are per unit of time. */
    private class Stage(private val filling: Double, val rate: Double) {
        fun filling(box: Box) = if (box.space.isPlane) PLANE * filling else filling
    }

    /** Of lengths, where volumes change by the factor [ofVolumes]. */
    private fun scale(ofVolumes: Double, box: Box): Double =
        if (box.space.isPlane) sqrt(ofVolumes) else StrictMath.cbrt(ofVolumes)

    private companion object {
        /** Spheres find places at random with few tries. */
        const val LOOSE = 0.2
        val STAGES = listOf(Stage(0.45, 0.5), Stage(0.55, 0.1), Stage(0.6, 0.02))
        const val SLOWEST = 0.002

        /**
         * Collisions per sphere in a stage; pressures that diverge as 3/(1 − φ/φ_J) take some 5,000 to
         * [GrowingGas.JAMMED].
         */
        const val MOST_WORK = 50_000

        /** Filling factors above which equal ones do not come. */
        const val MOST_SPHERES = 0.65
        const val MOST_DISCS = 0.9

        /** Of the start of growth to a pressure: filling factor over Z − 1, which is below that of every gas. */
        const val PER_PRESSURE = 0.1
        const val HALF = 0.5

        /**
         * Collisions of each sphere that a pressure is the mean of; fewer spheres than [FEW] need more, and time for
         * them.
         */
        const val WINDOW = 5.0
        const val FEW = 500.0

        /** Part of the pressure from which growth is slow. */
        const val NEAR = 0.8

        /** Growth over Z − 1 with which radii grow by a hundredth while a sphere has [WINDOW] collisions. */
        const val PER_WINDOW = 0.007

        /** By how much radii grow before the rate is looked at again. */
        const val PIECE = 0.02

        const val ROOM = 1 + 1e-9

        /** Filling factor at which discs jam over that at which spheres do. */
        const val PLANE = 1.3
    }
}

/**
 * What growth has made.
 *
 * @property positions places by sphere
 * @property factor by which radii are larger than those that were given
 */
public class GrownSpheres internal constructor(public val positions: Positions, public val factor: Double)
