package daphnis.core.population

/**
 * Sums over the population that collisions conserve (momentum, and energy when they are elastic), taken in the order of the
 * ids, so that they are the same to the last bit whatever order the arrays are in.
 *
 * @property kineticEnergy Σ m v²/2, in mass · (length/time)²
 * @property momentumX Σ m vx; likewise [momentumY], [momentumZ]
 * @property mass Σ m
 */
public class Conserved private constructor(
    public val count: Int,
    public val mass: Double,
    public val kineticEnergy: Double,
    public val momentumX: Double,
    public val momentumY: Double,
    public val momentumZ: Double,
) {
    public companion object {
        /** The sums of [population] as it stands. */
        public fun of(population: Population): Conserved {
            val sums = PopulationSums(null)
            sums.take(population)
            return Conserved(population.size, sums.mass, sums.kineticEnergy, sums.momentum(0), sums.momentum(1), sums.momentum(2))
        }
    }
}
