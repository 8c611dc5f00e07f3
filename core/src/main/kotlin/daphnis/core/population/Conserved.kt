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
            var mass = 0.0
            var energy = 0.0
            var px = 0.0
            var py = 0.0
            var pz = 0.0
            for (id in 0 until population.idBound) {
                val k = population.indexOf(id)
                if (k < 0) continue
                val m = population.mass[k]
                val vx = population.vx[k]
                val vy = population.vy[k]
                val vz = population.vz[k]
                mass += m
                energy += 0.5 * m * (vx * vx + vy * vy + vz * vz)
                px += m * vx
                py += m * vy
                pz += m * vz
            }
            return Conserved(population.size, mass, energy, px, py, pz)
        }
    }
}
