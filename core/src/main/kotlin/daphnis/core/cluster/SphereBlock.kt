package daphnis.core.cluster

import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import java.nio.ByteBuffer

/** Spheres in a message: their columns one after the other in the order of places, then the ids. */
internal object SphereBlock {
    /** Bytes of a sphere. */
    val BYTES: Int = SphereQuantity.WIDTH * Double.SIZE_BYTES + Int.SIZE_BYTES

    /** Reads [count] spheres. */
    fun read(from: ByteBuffer, count: Int): PopulationColumns =
        PopulationColumns(Array(SphereQuantity.WIDTH) { from.doubles(count) }, from.ints(count))

    /** Reads what [write] of one range of entries has written, with their number. */
    fun read(from: ByteBuffer): PopulationColumns = read(from, from.int)

    /** Writes entries [from] until [to] of [spheres] and their number. */
    fun write(to: MessageWriter, spheres: SphereColumns, from: Int, until: Int) {
        to.int(until - from)
        write(to, spheres) { it(from, until) }
    }

    /** Writes the entries of all ranges that [eachRange] goes through. */
    inline fun write(to: MessageWriter, spheres: SphereColumns, eachRange: ((from: Int, until: Int) -> Unit) -> Unit) {
        for (place in 0 until SphereQuantity.WIDTH) {
            val column = spheres.column(place)
            eachRange { from, until -> to.doubles(column, from, until) }
        }
        eachRange { from, until -> to.ints(spheres.id, from, until) }
    }
}
