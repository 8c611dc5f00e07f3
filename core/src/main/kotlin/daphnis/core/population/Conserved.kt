package daphnis.core.population

/**
 * Sums over the population that collisions conserve (momentum, and energy when they are elastic), without
 * round-off ([ExactSum]), so that they are the same to the last bit whatever order the arrays are in.
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
        /** The sums of the present state of [population]. */
        @JvmStatic
        public fun of(population: Population): Conserved {
            val s = PopulationSums(null)
            s.take(population)
            return Conserved(s.count, s.mass, s.kineticEnergy, s.momentum(0), s.momentum(1), s.momentum(2))
        }

        /** The sums of a population that is held in [parts]. */
        internal fun of(parts: SumParts): Conserved {
            val s = FirstMoments(0, Int.MAX_VALUE)
            parts.first(s)
            return Conserved(s.spheres, s.mass, s.kineticEnergy, s.momentum(0), s.momentum(1), s.momentum(2))
        }
    }
}
