package daphnis.core.format

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.population.Population

/**
 * The state at one time as files hold it: spheres in the order of their ids, one entry each in every array.
 *
 * @property lengths edges of the box along x, y, z; NaN on open axes
 * @property periodic whether the box repeats along x, y, z
 * @property image boxes crossed since the start of the run, `image[axis][k]`, or null when it is not known; without
 *   images a sphere would be at position + Σ image · [edges]
 * @property hasMass whether [mass] is from the file; false when the file had none and the reader substituted one
 *   @property hasRadius the same for [radius]
 * @property shearOffset displacement along [slideAxis] of the image one box up [normalAxis], where images slide; else 0
 * @property hasTime whether [time] is from the file; false when the file had none, and it is the number of the step
 * @property hasVelocity whether [velocity] is from the file; false when the file had none along some axis, and it is 0
 * @property shift what a file's coordinates x, y, z had more than [position], whose box is centred on the origin
 */
public class Snapshot @JvmOverloads constructor(
    public val step: Long,
    public val time: Double,
    public val lengths: DoubleArray,
    public val periodic: BooleanArray,
    public val shearOffset: Double,
    public val id: IntArray,
    public val position: Array<DoubleArray>,
    public val velocity: Array<DoubleArray>,
    public val radius: DoubleArray,
    public val mass: DoubleArray,
    public val normalAxis: Int = 1,
    public val slideAxis: Int = 0,
    public val hasMass: Boolean = true,
    public val hasRadius: Boolean = true,
    public val image: Array<IntArray>? = null,
    public val hasTime: Boolean = true,
    public val shift: DoubleArray = DoubleArray(3),
    public val hasVelocity: Boolean = true,
) {
    /** Number of spheres. */
    public val size: Int get() = id.size

    /** The same state, arrays shared, at a [time] which is then known. */
    public fun at(time: Double): Snapshot = with(time = time, hasTime = true)

    /**
     * The same state with every sphere inside the box along the axes that repeat, and the boxes it is moved by in
     * [image], where that is known. Along a sliding face a sphere moves to its image; velocities stay. Arrays that need
     * no change are shared.
     *
     * @param boundary whose box it is, centred on the origin; null for the state's own
     */
    @JvmOverloads
    public fun folded(boundary: BoundaryConditions? = null): Snapshot {
        val places = Array(3) { position[it].copyOf() }
        val boxes = (boundary?.let { FoldedCell.of(it, time) } ?: FoldedCell.of(this)).fold(places) ?: return this
        val sum = image?.let { known -> Array(3) { axis -> IntArray(size) { known[axis][it] + boxes[axis][it] } } }
        return with(position = places, image = sum)
    }

    /** The same state, where positions are known to be those without a box: no box was crossed. */
    public fun unwrapped(): Snapshot = with(image = Array(3) { IntArray(size) })

    internal fun with(
        time: Double = this.time,
        hasTime: Boolean = this.hasTime,
        position: Array<DoubleArray> = this.position,
        radius: DoubleArray = this.radius,
        image: Array<IntArray>? = this.image,
        hasVelocity: Boolean = this.hasVelocity,
    ): Snapshot = Snapshot(
        step, time, lengths, periodic, shearOffset, id, position, velocity, radius, mass, normalAxis, slideAxis,
        hasMass, hasRadius, image, hasTime, shift, hasVelocity,
    )

    /** Edge vectors of the cell, by row: the one along [normalAxis] leans by the offset of sliding images. */
    public fun edges(): Array<DoubleArray> = Array(3) { row ->
        DoubleArray(3) { axis ->
            if (axis == row) {
                lengths[row]
            } else if (row == normalAxis && axis == slideAxis) {
                shearOffset
            } else {
                0.0
            }
        }
    }

    /** The snapshot as a population, with the same ids. */
    public fun population(): Population = Population(
        position[0].copyOf(), position[1].copyOf(), position[2].copyOf(),
        velocity[0].copyOf(), velocity[1].copyOf(), velocity[2].copyOf(),
        radius.copyOf(), mass.copyOf(), id.copyOf(),
    )

    public companion object {
        /** Copies the state of [population] at [step] and [time]. */
        @JvmStatic
        @JvmOverloads
        public fun of(
            population: Population,
            boundary: BoundaryConditions,
            step: Long,
            time: Double,
            hasMass: Boolean = true,
        ): Snapshot {
            val order = population.indicesById()
            val n = order.size
            fun pick(a: DoubleArray) = DoubleArray(n) { a[order[it]] }
            return Snapshot(
                step,
                time,
                DoubleArray(3) { axis -> boundary.box.length(axis).let { if (it.isFinite()) it else Double.NaN } },
                BooleanArray(3) { boundary.repeats(it) },
                boundary.shear?.offset(time) ?: 0.0,
                IntArray(n) { population.id[order[it]] },
                arrayOf(pick(population.x), pick(population.y), pick(population.z)),
                arrayOf(pick(population.vx), pick(population.vy), pick(population.vz)),
                pick(population.radius),
                pick(population.mass),
                boundary.shear?.normalAxis ?: 1,
                boundary.shear?.slideAxis ?: 0,
                hasMass = hasMass,
                image = image(population, boundary, time, order),
            )
        }

        /** The edges lean by the reduced offset, so boxes along the slide are counted from there. */
        private fun image(
            population: Population,
            boundary: BoundaryConditions,
            time: Double,
            order: IntArray,
        ): Array<IntArray> {
            val image =
                Array(3) { axis -> IntArray(order.size) { population.boxesCrossed(population.id[order[it]], axis) } }
            val shear = boundary.shear ?: return image
            val turns = shear.turns(time)
            val across = image[shear.normalAxis]
            val along = image[shear.slideAxis]
            for (k in along.indices) along[k] += (across[k] * turns).toInt()
            return image
        }
    }
}
