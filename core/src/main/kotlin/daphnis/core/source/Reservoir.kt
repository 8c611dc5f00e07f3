package daphnis.core.source

import daphnis.core.boundary.Box
import daphnis.core.growth.IntList
import daphnis.core.space.Space
import kotlin.math.ceil
import kotlin.math.min
import kotlin.math.sqrt

/**
 * Holds the spheres in [region] as if they were in contact with a large gas of elastic hard spheres, which fill the part
 * [fillingFactor] of it and have the [temperature], mass · (length/time)². In each step it makes [trials]: each brings a
 * sphere anywhere in the region, with a velocity of that gas, or takes one of those whose centres are there; either is
 * tried as often. With N spheres there and the activity z = n exp(μ_ex/kT), one that overlaps nothing comes with the
 * probability min(1, zV/(N + 1)), and one leaves with min(1, N/(zV)) (Adams 1975, Mol. Phys.
 * 29, 307). These moves and elastic impacts both keep the grand canonical distribution: in all of a box
 * at rest, and not only in the region, as two such regions at the ends of a box drive diffusion through it (Heffelfinger &
 * van Swol 1994, J. Chem. Phys. 100, 7548).
 *
 * μ_ex is that of Carnahan & Starling, of discs that of Henderson. Spheres of other sizes, masses or materials are never
 * taken, and not counted in N.
 *
 * @param supply of spheres of one size
 * @property trials per step; 0 for as many as the region holds spheres
 * @throws IllegalArgumentException for numbers that are out of range
 */
public class Reservoir @JvmOverloads constructor(
    public val region: Box,
    public val fillingFactor: Double,
    public val temperature: Double,
    private val supply: Supply,
    trials: Int = 0,
) : Source() {
    private val radius = supply.largest
    private val mass = supply.mass(radius, region.space)

    /** Spheres that the region holds on average. */
    public val expected: Double = fillingFactor * region.volume / region.space.volume(radius)
    public val trials: Int = if (trials == 0) ceil(expected).toInt() else trials

    /** zV. */
    private val activity = expected * StrictMath.exp(excessChemicalPotential(fillingFactor, region.space))

    init {
        require(region.isFinite) { "the region is infinite" }
        require(fillingFactor > 0 && fillingFactor < MOST_FILLING) {
            "the filling factor is $fillingFactor; it must be in (0, $MOST_FILLING), a fluid"
        }
        require(temperature > 0 && temperature.isFinite()) { "the temperature is $temperature; it must be > 0" }
        require(trials >= 0) { "there are $trials trials in a step; it must be at least 1" }
    }

    override val largest: Double get() = radius

    override fun act(step: SourceStep) {
        val p = step.population
        val lower = DoubleArray(AXES) { region.lower(it) }
        val upper = DoubleArray(AXES) { region.upper(it) }
        val near = step.near(lower, upper, radius) { k ->
            region.contains(p.x[k], p.y[k], p.z[k]) &&
                p.radius[k] == radius &&
                p.mass[k] == mass &&
                (!p.hasMaterials || p.material[k] == supply.material.toDouble())
        }
        val there = IntList()
        for (n in 0 until near.size) if (near.isOwn(n)) there.add(n)
        val first = near.size
        val come = LinkedHashMap<Int, Newcomer>()
        val gone = HashSet<Int>()
        val random = step.random
        repeat(trials) {
            if (random.nextDouble() < HALF) {
                val sphere = draw(step)
                val isTaken = random.nextDouble() * (there.size + 1) < activity
                if (isTaken && step.isInRoom(sphere.position, radius) && near.isFree(sphere.position, radius)) {
                    val n = near.add(NO_ID, sphere.position, radius, isOwn = true)
                    there.add(n)
                    come[n] = sphere
                }
            } else if (there.size > 0) {
                val k = random.nextInt(there.size)
                if (random.nextDouble() * activity < min(there.size.toDouble(), activity)) {
                    val n = there[k]
                    there[k] = there[there.size - 1]
                    there.removeLast()
                    near.remove(n)
                    if (n < first) gone += near.id(n) else come.remove(n)
                }
            }
        }
        if (gone.isNotEmpty()) step.remove { p.id[it] in gone }
        step.add(come.values.toList())
    }

    private fun draw(step: SourceStep): Newcomer {
        val random = step.random
        val sphere = Newcomer(radius, mass, supply.material)
        val sigma = sqrt(temperature / mass)
        val axes = step.space.dimensions
        for (k in 0 until axes) {
            sphere.position[k] = random.nextDouble(region.lower(k), region.upper(k))
            sphere.velocity[k] = sigma * random.nextGaussian()
        }
        val spread = step.spinSpread(sphere, temperature)
        if (spread >
            0
        ) {
            for (k in AXES - step.space.rotations until AXES) sphere.spin[k] = spread * random.nextGaussian()
        }
        return sphere
    }

    public companion object {
        /** Above it hard spheres may be crystals. */
        public const val MOST_FILLING: Double = 0.49
        private const val AXES = 3
        private const val NO_ID = -1
        private const val HALF = 0.5

        /**
         * μ_ex/kT of a fluid of equal spheres with the filling factor [filling]: of Carnahan & Starling 1969, J. Chem.
         * Phys. 51, 635; of discs that of Henderson 1975, Mol. Phys. 30, 971.
         */
        internal fun excessChemicalPotential(filling: Double, space: Space): Double {
            val free = 1 - filling
            if (!space.isPlane) return filling * (8 - filling * (9 - 3 * filling)) / (free * free * free)
            val pressure = (1 + filling * filling / 8) / (free * free)
            return 9.0 / 8 * filling / free - 7.0 / 8 * StrictMath.log(free) + pressure - 1
        }
    }
}
