package daphnis.core.force.thermostat

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Open
import daphnis.core.random.CounterRandom
import kotlin.math.sqrt

/**
 * Andersen's thermostat (1980, J. Chem. Phys. 72, 2384): now and then a sphere gets a new velocity out of a bath, with
 * the variance T/m of each component.
 *
 * @property rate at which each sphere does, per unit of time
 * @property temperature T of the bath, mass · (length/time)²
 * @throws IllegalArgumentException when a number is negative or not finite
 */
public class Andersen @JvmOverloads constructor(
    seed: Long,
    public val rate: Double,
    public val temperature: Double,
    conservesMomentum: Boolean = false,
    override val boundary: BoundaryConditions = Open,
    override val firstBody: Int = Int.MAX_VALUE,
) : RandomKicks(seed, conservesMomentum) {
    init {
        require(rate >= 0 && rate.isFinite()) { "rate is $rate; it must be at least 0" }
        require(temperature >= 0 && temperature.isFinite()) { "temperature is $temperature; it must be at least 0" }
    }

    private var chance = 0.0

    override fun prepare(duration: Double) {
        chance = -StrictMath.expm1(-rate * duration)
    }

    override fun kick(w: Double, mass: Double, drawn: CounterRandom, word: Int): Double =
        if (drawn.uniform(CHANCE) < chance) sqrt(temperature / mass) * drawn.gaussian(word) - w else 0.0

    private companion object {
        const val CHANCE = 3
    }
}
