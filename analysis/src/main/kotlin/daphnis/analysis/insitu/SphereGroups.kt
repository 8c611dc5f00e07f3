package daphnis.analysis.insitu

import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * Particles told apart, as by their size: measures that are taken of each group by itself have one as a parameter. A
 * particle is in one group at most; bodies are in none, whatever [of] says of them.
 */
public interface SphereGroups {
    /** Number of groups, at least 1. */
    public val count: Int

    /** The group of the sphere at [index] of [state], in 0 until [count]; −1 for none. */
    public fun of(state: State, index: Int): Int

    public companion object {
        /** One group of all particles. */
        @JvmField
        public val ALL: SphereGroups = object : SphereGroups {
            override val count = 1

            override fun of(state: State, index: Int) = 0
        }
    }
}

/**
 * The materials of the spheres, group by number.
 *
 * @property count number of materials
 */
public class MaterialGroups(override val count: Int) : SphereGroups {
    init {
        require(count >= 1) { "there are $count materials; there must be one at least" }
    }

    override fun of(state: State, index: Int): Int {
        val p = state.population
        return if (p.hasMaterials) p.material[index].toInt().let { if (it < count) it else -1 } else -1
    }

    public companion object {
        /** Those of the spheres of [sample]; null where these have none. */
        @JvmStatic
        public fun of(sample: State): MaterialGroups? =
            sample.population.materials.size.let { if (it > 0) MaterialGroups(it) else null }
    }
}

/**
 * Classes of radii.
 *
 * @param edges lower edges of the classes and the upper edge of the last, ascending; the last class includes its upper
 *   edge
 */
public class SizeGroups(private val edges: DoubleArray) : SphereGroups {
    override val count: Int = edges.size - 1

    init {
        require(count >= 1 && (0 until count).all { edges[it] < edges[it + 1] }) {
            "edges are ${edges.asList()}; they must ascend"
        }
    }

    override fun of(state: State, index: Int): Int {
        val radius = state.population.radius[index]
        if (radius < edges[0] || radius > edges[count]) return -1
        var c = 0
        while (c < count - 1 && radius >= edges[c + 1]) c++
        return c
    }

    public companion object {
        private const val SAME = 1e-9

        /**
         * Classes for the particles of [sample]: one for each radius when there are at most [most], else [most] of
         * equal width in ln r. Null for one size.
         */
        @JvmStatic
        @JvmOverloads
        public fun of(sample: State, most: Int = 8): SizeGroups? {
            val p = sample.population
            val radii = (0 until p.size).filter { sample.isParticle(it) }.map { p.radius[it] }.sorted()
            val distinct = ArrayList<Double>()
            for (r in radii) if (distinct.isEmpty() || abs(r / distinct.last() - 1) > SAME) distinct += r
            if (distinct.size < 2) return null
            val ratio = radii.last() / radii.first()
            val edges = if (distinct.size <= most) {
                DoubleArray(distinct.size + 1) {
                    sqrt(distinct[maxOf(0, it - 1)] * distinct[minOf(it, distinct.size - 1)])
                }
            } else {
                DoubleArray(most + 1) {
                    if (it == most) radii.last() else radii.first() * ratio.pow(it / most.toDouble())
                }
            }
            return SizeGroups(edges)
        }
    }
}
