@file:JvmName("Digest")

package daphnis.core.population

import java.nio.ByteBuffer
import java.security.MessageDigest
import java.util.HexFormat

/**
 * The state digest: SHA-256 over x y z vx vy vz of all spheres in the order of their ids, as big-endian IEEE doubles.
 * Where spheres have spins, ωx ωy ωz of all follow, in the same order. Where pairs have states
 * ([SphereColumns.bonds]), lower id, higher id and state of each follow, as big-endian ints, in the order of ids.
 *
 * Two runs with the same digest have the same trajectory to the last bit. The digest does not depend on the order in
 * which the arrays are kept.
 *
 * @return 64 hexadecimal digits
 */
public fun stateDigest(population: Population): String {
    val sha = MessageDigest.getInstance("SHA-256")
    sha.update(population, MOTION)
    if (population.hasSpin) sha.update(population, SPIN)
    val pairs = Bonds.pairs(population, population.indicesById())
    sha.update(ByteBuffer.allocate(pairs.size * Int.SIZE_BYTES).apply { asIntBuffer().put(pairs) }.array())
    return HexFormat.of().formatHex(sha.digest())
}

/** Takes in the columns of all spheres at these [places]. */
private fun MessageDigest.update(population: Population, places: IntArray) {
    val block = ByteBuffer.allocate(places.size * Double.SIZE_BYTES * SPHERES_PER_BLOCK)
    for (sphere in 0 until population.places) {
        val k = population.indexAt(sphere)
        if (k < 0) continue
        for (place in places) block.putDouble(population.column(place)[k])
        if (!block.hasRemaining()) {
            update(block.array())
            block.clear()
        }
    }
    update(block.array(), 0, block.position())
}

private val MOTION = SphereQuantity.places { it.isDigested && !it.isOptional }
private val SPIN = SphereQuantity.places { it.isDigested && it.isOptional }
private const val SPHERES_PER_BLOCK = 512
