package daphnis.core.cluster

import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import java.nio.ByteBuffer

/** Spheres that came in a message. */
internal class SphereBlock(
    override val x: DoubleArray,
    override val y: DoubleArray,
    override val z: DoubleArray,
    override val vx: DoubleArray,
    override val vy: DoubleArray,
    override val vz: DoubleArray,
    override val radius: DoubleArray,
    override val mass: DoubleArray,
    override val lastCollision: DoubleArray,
    override val id: IntArray,
) : SphereColumns {
    override val size: Int get() = id.size

    /** Copies all to entries [at] and following of [columns]. */
    fun copyInto(columns: PopulationColumns, at: Int) {
        x.copyInto(columns.x, at)
        y.copyInto(columns.y, at)
        z.copyInto(columns.z, at)
        vx.copyInto(columns.vx, at)
        vy.copyInto(columns.vy, at)
        vz.copyInto(columns.vz, at)
        radius.copyInto(columns.radius, at)
        mass.copyInto(columns.mass, at)
        lastCollision.copyInto(columns.lastCollision, at)
        id.copyInto(columns.id, at)
    }

    companion object {
        /** Bytes of a sphere in a message. */
        const val BYTES = 9 * Double.SIZE_BYTES + Int.SIZE_BYTES

        /** Reads [count] spheres. */
        fun read(from: ByteBuffer, count: Int): SphereBlock {
            val columns = Array(9) { from.doubles(count) }
            return SphereBlock(
                columns[0], columns[1], columns[2], columns[3], columns[4], columns[5], columns[6], columns[7],
                columns[8], from.ints(count),
            )
        }

        /** Reads what [write] of one range of entries has written, with their number. */
        fun read(from: ByteBuffer): SphereBlock = read(from, from.int)

        /** Writes entries [from] until [to] of [spheres] and their number. */
        fun write(to: MessageWriter, spheres: SphereColumns, from: Int, until: Int) {
            to.int(until - from)
            eachColumn(spheres) { to.doubles(it, from, until) }
            to.ints(spheres.id, from, until)
        }

        /** All columns of doubles, in the order of a message. */
        inline fun eachColumn(spheres: SphereColumns, act: (DoubleArray) -> Unit) {
            act(spheres.x)
            act(spheres.y)
            act(spheres.z)
            act(spheres.vx)
            act(spheres.vy)
            act(spheres.vz)
            act(spheres.radius)
            act(spheres.mass)
            act(spheres.lastCollision)
        }

        /** The entries of all [parts] one after the other. */
        fun joined(parts: List<SphereColumns>): SphereBlock {
            val count = parts.sumOf { it.size }
            val columns = Array(9) { DoubleArray(count) }
            val id = IntArray(count)
            var at = 0
            for (part in parts) {
                var column = 0
                eachColumn(part) { it.copyInto(columns[column++], at, 0, part.size) }
                part.id.copyInto(id, at, 0, part.size)
                at += part.size
            }
            return SphereBlock(
                columns[0], columns[1], columns[2], columns[3], columns[4], columns[5], columns[6], columns[7],
                columns[8], id,
            )
        }
    }
}
