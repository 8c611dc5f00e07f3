@file:JvmName("Digest")

package daphnis.core.population

import java.nio.ByteBuffer
import java.security.MessageDigest
import java.util.HexFormat

/**
 * The state digest: SHA-256 over x y z vx vy vz of all spheres in the order of their ids, as big-endian IEEE doubles.
 *
 * Two runs with the same digest have the same trajectory to the last bit. The digest does not depend on the order in
 * which the arrays are kept.
 *
 * @return 64 hexadecimal digits
 */
public fun stateDigest(population: Population): String {
    val sha = MessageDigest.getInstance("SHA-256")
    val block = ByteBuffer.allocate(BYTES_PER_SPHERE * SPHERES_PER_BLOCK)
    for (place in 0 until population.places) {
        val k = population.indexAt(place)
        if (k < 0) continue
        for (place in DIGESTED) block.putDouble(population.column(place)[k])
        if (!block.hasRemaining()) {
            sha.update(block.array())
            block.clear()
        }
    }
    sha.update(block.array(), 0, block.position())
    return HexFormat.of().formatHex(sha.digest())
}

private val DIGESTED = SphereQuantity.places { it.isDigested }
private val BYTES_PER_SPHERE = DIGESTED.size * Double.SIZE_BYTES
private const val SPHERES_PER_BLOCK = 512
