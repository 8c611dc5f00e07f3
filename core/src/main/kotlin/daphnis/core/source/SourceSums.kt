package daphnis.core.source

import daphnis.core.population.ExactSums
import daphnis.core.population.Population

/** What the sources of a simulation have brought and taken: by source, in steps or since the start of a run. */
internal class SourceSums(val sources: Int) : ExactSums() {
    override val counts: LongArray = LongArray(COUNTS * sources)

    /** Spheres that have come from [source]. */
    fun came(source: Int): Long = counts[COUNTS * source]

    /** Spheres that have left by it. */
    fun left(source: Int): Long = counts[COUNTS * source + 1]

    /** Spheres that found no place. */
    fun refused(source: Int): Long = counts[COUNTS * source + 2]

    /** Mass that has come, less what has left; likewise [momentum] and [energy], kinetic and of rotation. */
    fun mass(source: Int): Double = value(SUMS * source)

    fun momentum(source: Int, axis: Int): Double = value(SUMS * source + MOMENTUM + axis)

    fun energy(source: Int): Double = value(SUMS * source + ENERGY)

    fun refuse(source: Int, spheres: Int) {
        counts[COUNTS * source + 2] += spheres.toLong()
    }

    /** The sphere at index [k] comes ([sign] 1) or leaves (−1). @param inertia moment of inertia over mass · radius² */
    fun add(source: Int, p: Population, k: Int, sign: Double, inertia: Double) {
        counts[COUNTS * source + if (sign > 0) 0 else 1]++
        count++
        val first = SUMS * source
        val m = sign * p.mass[k]
        sum(first).add(m)
        for (axis in 0 until AXES) sum(first + MOMENTUM + axis).add(m * p.velocity(axis)[k])
        val energy = sum(first + ENERGY)
        energy.add(m * (p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]) / 2)
        if (!p.hasSpin) return
        val squared = p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k]
        energy.add(m * inertia * p.radius[k] * p.radius[k] * squared / 2)
    }

    private companion object {
        const val AXES = 3
        const val COUNTS = 3
        const val MOMENTUM = 1
        const val ENERGY = 4
        const val SUMS = 5
    }
}
