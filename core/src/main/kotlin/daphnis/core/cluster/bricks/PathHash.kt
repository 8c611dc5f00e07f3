package daphnis.core.cluster.bricks

import daphnis.core.population.Bonds
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.optional

/**
 * A hash of 64 bits of the path of a sphere within a step: of the state with which it starts, and of every impact, also
 * one that changes no velocity, since it changes where rounding happens. Two computations of a sphere agree when their
 * hashes do. Paths that differ have the same hash with a probability of 2⁻⁶⁴.
 */
internal object PathHash {
    /** Of a path without impacts. */
    const val STRAIGHT: Long = 0x2545F4914F6CDD1DL

    private val NOTES = SphereQuantity.LAST_COLLISION.places
    private const val FACTOR = -0x61c8864680b583ebL

    /** [hash] with [word] taken in. */
    fun mix(hash: Long, word: Long): Long {
        val h = (hash xor word) * FACTOR
        return h xor (h ushr 32)
    }

    /** [hash] with the bits of [number] taken in. */
    fun mix(hash: Long, number: Double): Long = mix(hash, number.toRawBits())

    /** The hash of the [path], of impacts, of entry [k] of [spheres], and of the state there with which it starts. */
    fun whole(path: Long, spheres: SphereColumns, k: Int, tracksLastCollision: Boolean): Long {
        var h = mix(path, spheres.id[k].toLong())
        for (place in SphereQuantity.present(spheres.optional)) {
            if (tracksLastCollision || place !in NOTES) h = mix(h, spheres.column(place)[k])
        }
        if (spheres.bonds !== Bonds.NONE) for (number in spheres.bonds[k]) h = mix(h, number.toLong())
        return h
    }
}
