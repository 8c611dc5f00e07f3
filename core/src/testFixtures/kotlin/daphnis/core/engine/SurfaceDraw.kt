package daphnis.core.engine

import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.Restitution
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRoughness
import daphnis.core.surface.CoulombRoughness
import daphnis.core.surface.Roughness
import daphnis.core.surface.SurfaceContact

/**
 * Surfaces of the spheres of a drawn case, and of its walls: rough ones in a third of all. They have random numbers of
 * their own, so that what else is drawn from [seed] is as without them.
 */
class SurfaceDraw(seed: Long) {
    private val random = SeededRandom(seed + APART)
    private val isRough = random.nextInt(3) == 0

    val roughness: Roughness? = drawn()
    val momentFactor: Double = if (isRough) random.nextDouble(0.1, 0.66) else SurfaceContact.SOLID

    /** Some rough, some smooth; none where nothing is rough. */
    val walls: List<Roughness?> = if (isRough) List(FACES) { drawn() } else emptyList()

    private fun drawn(): Roughness? {
        if (!isRough) return null
        return when (random.nextInt(5)) {
            0 -> null
            1 -> ConstantRoughness(1.0)
            2 -> ConstantRoughness(random.nextDouble(-1.0, 1.0))
            3 -> CoulombRoughness(random.nextDouble(0.0, 1.0), random.nextDouble(-1.0, 1.0))
            else -> Roughness { 0.5 - it.firstRadius / (it.firstRadius + 1.0) }
        }
    }

    /** [population] with spins such that surfaces are about as fast as centres. */
    fun of(population: Population): Population {
        if (!isRough) return population
        val n = population.size
        val speed = (0 until n).sumOf { Math.abs(population.vx[it]) } / n
        val isZero = random.nextInt(4) == 0
        fun spins() = DoubleArray(n) {
            if (isZero) random.nextInt(2) * -0.0 else random.nextGaussian() * speed / population.radius[it]
        }
        return population.withSpin(spins(), spins(), spins())
    }

    /** Collisions of such spheres, which are recorded. */
    fun collisions(restitution: Restitution, guard: CollapseGuard, engine: CollisionEngine) = CollisionForcing(
        restitution,
        guard,
        engine,
        recordCollisions = true,
        roughness = roughness,
        momentFactor = momentFactor,
    )

    override fun toString(): String = if (isRough) ", rough" else ""

    private companion object {
        const val APART = 1L shl 40
        const val FACES = 6
    }
}
