package daphnis.core.cluster

import daphnis.core.population.Bonds
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.optional
import java.nio.ByteBuffer

/**
 * Spheres in a message: the set of optional quantities that they have, their columns one after the other in the order of
 * places, the ids, and the list of partners of each, its length before it, where pairs have states.
 */
internal object SphereBlock {
    /** Bytes of [count] of these [spheres], with their number. */
    fun bytes(spheres: SphereColumns, count: Int): Int =
        count * (SphereQuantity.present(spheres.optional).size * Double.SIZE_BYTES + Int.SIZE_BYTES) + HEAD

    /** Reads [count] spheres. */
    fun read(from: ByteBuffer, count: Int): PopulationColumns {
        val columns = Array(SphereQuantity.WIDTH) { SphereQuantity.NONE }
        val optional = from.get().toInt()
        for (place in SphereQuantity.present(optional)) columns[place] = from.doubles(count)
        val ids = from.ints(count)
        if (optional and SphereQuantity.BONDED == 0) return PopulationColumns(columns, ids)
        return PopulationColumns(columns, ids, Array(count) { from.ints(from.int) })
    }

    /** Reads what [write] of one range of entries has written, with their number. */
    fun read(from: ByteBuffer): PopulationColumns = read(from, from.int)

    /** Writes entries [from] until [to] of [spheres] and their number. */
    fun write(to: MessageWriter, spheres: SphereColumns, from: Int, until: Int) {
        to.int(until - from)
        write(to, spheres) { it(from, until) }
    }

    /** Writes the entries of all ranges that [eachRange] goes through. */
    inline fun write(to: MessageWriter, spheres: SphereColumns, eachRange: ((from: Int, until: Int) -> Unit) -> Unit) {
        to.byte(spheres.optional)
        for (place in SphereQuantity.present(spheres.optional)) {
            val column = spheres.column(place)
            eachRange { from, until -> to.doubles(column, from, until) }
        }
        eachRange { from, until -> to.ints(spheres.id, from, until) }
        if (spheres.bonds === Bonds.NONE) return
        eachRange { from, until ->
            for (k in from until until) spheres.bonds[k].let { to.int(it.size).ints(it) }
        }
    }

    private const val HEAD = Int.SIZE_BYTES + Byte.SIZE_BYTES
}
