package daphnis.core.engine

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.potential.Bridge
import daphnis.core.potential.PairInteraction
import daphnis.core.potential.PairInteractions
import daphnis.core.potential.SteppedPotential

/** What spheres of a drawn gas do to one another besides impacts: nothing in most. Everything follows from [seed]. */
internal class InteractionDraw(private val seed: Long) {
    private val random = SeededRandom(seed xor 0x5eed)
    private val isSoft = random.nextInt(4) == 0

    /**
     * The interactions of [population] within [boundary]; null for none, and where an image would be within reach
     * beside the nearest.
     */
    fun of(population: Population, boundary: BoundaryConditions): PairInteractions? {
        if (seed % 3 != 1L || population.size == 0) return null
        val largest = population.radius.max()
        val room = (0..2).filter { boundary.hasImages(it) }.minOfOrNull { boundary.box.length(it) } ?: 1e9
        val most = minOf(2.5, room / (4.01 * largest))
        if (most < 1.05) return null
        val mass = population.mass.average()
        val all = PairInteractions(if (random.nextInt(4) == 0) null else potential(most, mass))
        if (!population.hasMaterials) return all
        return all.between(0, 1, potential(most, mass)).between(0, 0, if (random.nextInt(2) == 0) null else all.others)
    }

    private fun potential(most: Double, mass: Double): PairInteraction {
        if (random.nextInt(3) == 0) {
            val exponent = if (random.nextInt(2) == 0) 0.0 else 4.0 / 3
            return Bridge(random.nextDouble(1.01, most), mass * random.nextDouble(0.01, 1.0), 0.7, exponent)
        }
        val steps = 1 + random.nextInt(4)
        val ratios = DoubleArray(steps) { random.nextDouble(1.01, most) }.apply { sort() }.reversedArray()
        if (isSoft) ratios[steps - 1] = 1.0
        return SteppedPotential(ratios, DoubleArray(steps) { mass * random.nextDouble(-2.0, 2.0) })
    }
}
