package daphnis.core.engine

import daphnis.core.collision.CollapseGuard
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRoughness
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.CoulombRoughness
import daphnis.core.surface.MaterialLaws
import daphnis.core.surface.Restitution
import daphnis.core.surface.RoughContact
import daphnis.core.surface.Roughness
import daphnis.core.surface.SurfaceContact

/**
 * Surfaces of the spheres of a drawn case, and of its walls: rough ones in a third of all. They have random numbers of
 * their own, so that what else is drawn from [seed] is as without them.
 */
class SurfaceDraw(private val seed: Long) {
    private val random = SeededRandom(seed + APART)
    private val isRough = random.nextInt(3) == 0

    /** Whether the law is one of both coefficients that looks at all there is to see. */
    private val isTold = SeededRandom(seed + FURTHER).nextInt(4) == 0

    private val roughness: Roughness? = drawn()
    val momentFactor: Double = if (isRough) random.nextDouble(0.1, 0.66) else SurfaceContact.SOLID

    /** Some rough, some smooth; none where nothing is rough. */
    val walls: List<Roughness?> = if (isRough) List(FACES) { drawn() } else emptyList()

    /** How many materials there are in the fourth part of all cases that has some; 0 in others. */
    private val materials = SeededRandom(seed + MADE).let { if (it.nextInt(4) == 0) 1 + it.nextInt(3) else 0 }

    /** The law of spheres whose ε is at least that of [restitution], so that they collapse no sooner. */
    fun law(restitution: Restitution): ContactLaw = byMaterial(restitution, ofAll(restitution))

    private fun ofAll(restitution: Restitution): ContactLaw = when {
        isTold -> Told(restitution, isRough)
        roughness == null -> restitution
        else -> RoughContact(restitution, roughness)
    }

    /** Some pairs are elastic, some smooth, some less elastic or less rough than others. */
    private fun byMaterial(restitution: Restitution, others: ContactLaw): ContactLaw {
        val random = SeededRandom(seed + PAIRS)
        var laws = MaterialLaws(others)
        for (first in 0 until materials) {
            for (second in first until materials) {
                val least = random.nextDouble()
                val normal = Restitution { least + (1 - least) * restitution.coefficient(it) }
                val surface = if (isRough) ConstantRoughness(random.nextDouble(-1.0, 1.0)) else null
                when (random.nextInt(3)) {
                    0 -> laws = laws.between(first, second, normal)
                    1 -> laws = laws.between(second, first, surface?.let { RoughContact(normal, it) } ?: normal)
                }
            }
        }
        return if (materials == 0) others else laws
    }

    private class Told(private val restitution: Restitution, override val isRough: Boolean) : ContactLaw {
        override fun restitution(contact: SurfaceContact): Double {
            val least = restitution.coefficient(contact.normalSpeed)
            return least + (1 - least) * share(contact)
        }

        override fun roughness(contact: SurfaceContact): Double = share(contact) - contact.restitution

        /** In [0, 1], and other than for another contact. */
        private fun share(c: SurfaceContact): Double {
            val sizes = c.firstRadius / (c.firstRadius + 2 * c.secondRadius)
            val masses = c.firstMass / (c.firstMass + c.secondMass)
            val speeds = if (c.tangentialSpeed == 0.0) 1.0 else c.normalSpeed / (c.normalSpeed + c.tangentialSpeed)
            return sizes * masses * speeds
        }
    }

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

    /** [population] with spins such that surfaces are about as fast as centres, and with materials. */
    fun of(population: Population): Population {
        val random = SeededRandom(seed + MADE + 1)
        val spun = spun(population)
        if (materials == 0) return spun
        return spun.withMaterial(IntArray(population.size) { random.nextInt(materials) }, List(materials) { "m$it" })
    }

    private fun spun(population: Population): Population {
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
        law(restitution),
        guard,
        engine,
        recordCollisions = true,
        momentFactor = momentFactor,
    )

    override fun toString(): String = listOf(
        if (isRough) ", rough" else "",
        if (isTold) ", law of both" else "",
        if (materials > 0) ", $materials materials" else "",
    ).joinToString("")

    private companion object {
        const val APART = 1L shl 40
        const val FURTHER = 1L shl 41
        const val MADE = 1L shl 42
        const val PAIRS = 1L shl 43
        const val FACES = 6
    }
}
