package daphnis.core.scenario

import daphnis.core.initial.SizeDistribution
import daphnis.core.initial.SizesSpec
import daphnis.core.input.ValueCheck
import daphnis.core.space.Space

/**
 * Spheres that have one distribution of sizes and one law of masses: all, or those of one material.
 *
 * @property key what says so in the scenario
 * @property share of the number of all spheres
 * @param spec the distribution of sizes
 */
internal class SphereKind private constructor(
    val key: String,
    val share: Double,
    spec: SizesSpec,
    private val density: Double,
    private val mass: Double?,
    private val space: Space,
    private val check: ValueCheck,
) {
    val sizes: SizeDistribution = try {
        spec.distribution()
    } catch (e: IllegalArgumentException) {
        check.fail("$key.sizes", e.message.orEmpty())
    }

    /** The least and the largest radius. */
    val least: Double
    val most: Double

    init {
        val (least, most) = spec.range
        for (r in listOf(least, most)) {
            check.must("$key.sizes", r in ValueCheck.LEAST..ValueCheck.MOST) {
                "a radius is $r; it must be > 0, ${ValueCheck.LEAST} to ${ValueCheck.MOST}"
            }
        }
        this.least = least
        this.most = most
    }

    /** Refuses what can be no density or mass. */
    fun checkMass() {
        check.positive("$key.density", density)
        mass?.let { check.mass("$key.mass", it) }
    }

    /** The mass of a sphere of [radius], not checked. */
    fun weight(radius: Double): Double = mass ?: (density * space.volume(radius))

    /** The mass of a sphere of [radius]. */
    fun mass(radius: Double): Double {
        val mass = weight(radius)
        check.mass("$key.density", density, radius, mass)
        return mass
    }

    companion object {
        /** The kind at [key] of spheres with the [sizes] and a [mass], or a [density]. */
        fun of(
            key: String,
            sizes: SizesSpec,
            density: Double,
            mass: Double?,
            space: Space,
            check: ValueCheck,
        ): SphereKind = SphereKind(key, 1.0, sizes, density, mass, space, check).also { kind ->
            kind.checkMass()
            for (radius in listOf(kind.least, kind.most)) kind.mass(radius)
        }

        /** The kinds of the spheres of [spec], by number of material. */
        fun of(spec: ParticlesSpec, space: Space, check: ValueCheck): List<SphereKind> {
            val materials = spec.materials
            if (materials == null) {
                val sizes = spec.sizes ?: check.fail("particles.sizes", "is missing; give it, or materials")
                return listOf(SphereKind("particles", 1.0, sizes, spec.density, spec.mass, space, check))
            }
            val all = materials.sumOf { it.count?.toDouble() ?: 0.0 }
            return materials.mapIndexed { k, one ->
                val share = one.share ?: (one.count!! / all)
                SphereKind("particles.materials[$k]", share, one.sizes, one.density, one.mass, space, check)
            }
        }
    }
}
