package daphnis.core.format

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.population.Bonds
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import daphnis.core.population.optional

/**
 * The state at one time as files hold it: spheres in the order of their ids, one entry each in every array.
 *
 * @property lengths edges of the box along x, y, z; NaN on open axes
 * @property periodic whether the box repeats along x, y, z
 * @property image boxes crossed since the start of the run, `image[axis][k]`, or null when it is not known; without
 *   images a sphere would be at position + Σ image · [edges]
 * @property shearOffset displacement along [slideAxis] of the image one box up [normalAxis], where images slide; else 0
 * @property hasTime whether [time] is from the file; false when the file had none, and it is the number of the step
 * @property known quantities that are from the file; of others its readers substitute numbers
 * @property hasId whether [id] is from the file; false where particles are numbered in the order of the file
 * @property materials names of materials by number, as in [Population.materials]
 * @property species what the file says particles are made of, where nobody has said what materials that means
 * @property isFlat whether the file tells discs only, as it has no z, or a box that is too thin for spheres; z is 0
 * @property bound pairs that are bound, lower and higher id of each, as within an edge or bridged; null where that is not
 *   known
 * @property shift what a file's coordinates x, y, z had more than [position], whose box is centred on the origin
 */
public class Snapshot internal constructor(
    public val step: Long,
    public val time: Double,
    public val lengths: DoubleArray,
    public val periodic: BooleanArray,
    public val shearOffset: Double,
    override val id: IntArray,
    private val numbers: Array<DoubleArray>,
    public val normalAxis: Int,
    public val slideAxis: Int,
    internal val known: Set<SphereQuantity>,
    public val image: Array<IntArray>? = null,
    public val hasTime: Boolean = true,
    public val shift: DoubleArray = DoubleArray(3),
    public val hasId: Boolean = true,
    public val materials: List<String> = emptyList(),
    internal val species: Species? = null,
    public val isFlat: Boolean = false,
    public val bound: IntArray? = null,
) : SphereColumns {
    /**
     * @param hasMass whether [mass] is from the file; false when the file had none and the reader substituted one
     * @param hasRadius the same for [radius]
     * @param hasVelocity the same for [velocity]; false when the file had none along some axis
     */
    @JvmOverloads
    public constructor(
        step: Long,
        time: Double,
        lengths: DoubleArray,
        periodic: BooleanArray,
        shearOffset: Double,
        id: IntArray,
        position: Array<DoubleArray>,
        velocity: Array<DoubleArray>,
        radius: DoubleArray,
        mass: DoubleArray,
        normalAxis: Int = 1,
        slideAxis: Int = 0,
        hasMass: Boolean = true,
        hasRadius: Boolean = true,
        image: Array<IntArray>? = null,
        hasTime: Boolean = true,
        shift: DoubleArray = DoubleArray(3),
        hasVelocity: Boolean = true,
    ) : this(
        step, time, lengths, periodic, shearOffset, id,
        arrayOf(position[0], position[1], position[2], velocity[0], velocity[1], velocity[2], radius, mass),
        normalAxis, slideAxis,
        SphereQuantity.EXPORTED.filterTo(HashSet()) {
            when (it) {
                SphereQuantity.VELOCITY -> hasVelocity
                SphereQuantity.RADIUS -> hasRadius
                SphereQuantity.MASS -> hasMass
                else -> !it.isOptional
            }
        },
        image, hasTime, shift,
    )

    /** Whether nothing is out of the plane z = 0 or moves out of it: all z, v_z, and spins about x and y are 0. */
    public val isInPlane: Boolean
        get() = listOf(position[2], velocity[2]).all { column -> column.all { it == 0.0 } } &&
            (!hasSpin || columns(SphereQuantity.SPIN).take(2).all { column -> column.all { it == 0.0 } })

    /** Number of spheres. */
    override val size: Int get() = id.size

    /** Whether spheres have angular velocities. */
    override val hasSpin: Boolean get() = SphereQuantity.SPIN in known

    override fun column(place: Int): DoubleArray = when {
        SphereQuantity.at(place).let { it.isOptional && it !in known } -> SphereQuantity.NONE
        place < numbers.size -> numbers[place]
        else -> PopulationColumns.absent(place, size)
    }

    override val bonds: Array<IntArray> by lazy {
        if (bound == null || bound.isEmpty()) Bonds.NONE else Bonds.of(id, bound)
    }

    /** Positions, `position[axis][k]`. */
    public val position: Array<DoubleArray> = Array(3) { numbers[it] }

    /** Velocities, `velocity[axis][k]`. */
    public val velocity: Array<DoubleArray> = Array(3) { numbers[SphereQuantity.VELOCITY.place + it] }

    /** Whether [mass] is from the file; false when the file had none and the reader substituted one. */
    public val hasMass: Boolean get() = SphereQuantity.MASS in known

    /** The same for [radius]. */
    public val hasRadius: Boolean get() = SphereQuantity.RADIUS in known

    /** The same for [velocity]; false when the file had none along some axis. */
    public val hasVelocity: Boolean get() = SphereQuantity.VELOCITY in known

    /** What spheres have, other than what no file but a checkpoint has. */
    internal val quantities: List<SphereQuantity>
        get() = SphereQuantity.EXPORTED.filter { !it.isOptional || it in known }

    /** Names of the columns of numbers, as tables have them. */
    public val columnNames: List<String> get() = quantities.flatMap { it.columns }

    /** Places of the columns that [columnNames] names, see [column]. */
    public val columnPlaces: IntArray get() = quantities.flatMap { it.places }.toIntArray()

    /** Dimension of the column at [place], in the words of [daphnis.core.table.Dimension]. */
    public fun dimension(place: Int): String = SphereQuantity.at(place).dimension.words()

    /** The columns of [quantity]. */
    internal fun columns(quantity: SphereQuantity): List<DoubleArray> = quantity.places.map { column(it) }

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
        val places = Array(3) { position(it).copyOf() }
        val boxes = (boundary?.let { FoldedCell.of(it, time) } ?: FoldedCell.of(this)).fold(places) ?: return this
        val sum = image?.let { known -> Array(3) { axis -> IntArray(size) { known[axis][it] + boxes[axis][it] } } }
        return with(numbers = Array(numbers.size) { places.getOrElse(it) { _ -> numbers[it] } }, image = sum)
    }

    /** The same state, where positions are known to be those without a box: no box was crossed. */
    public fun unwrapped(): Snapshot = with(image = Array(3) { IntArray(size) })

    /** The same state, where it is not known which boxes were crossed. */
    public fun unknownImages(): Snapshot = with(image = null)

    internal fun with(
        time: Double = this.time,
        hasTime: Boolean = this.hasTime,
        numbers: Array<DoubleArray> = this.numbers,
        image: Array<IntArray>? = this.image,
        known: Set<SphereQuantity> = this.known,
        lengths: DoubleArray = this.lengths,
        shearOffset: Double = this.shearOffset,
        shift: DoubleArray = this.shift,
        hasId: Boolean = this.hasId,
        materials: List<String> = this.materials,
        bound: IntArray? = this.bound,
    ): Snapshot = Snapshot(
        step, time, lengths, periodic, shearOffset, id, numbers, normalAxis, slideAxis, known, image, hasTime, shift,
        hasId, materials, species, isFlat, bound,
    )

    /** The same state, arrays shared, of particles that are made of the materials [names], with these numbers. */
    internal fun withMaterials(numbers: IntArray, names: List<String>): Snapshot {
        val columns = Array(SphereQuantity.EXPORTED_WIDTH) { this.numbers.getOrElse(it) { SphereQuantity.NONE } }
        columns[SphereQuantity.MATERIAL.place] = DoubleArray(size) { numbers[it].toDouble() }
        return with(numbers = columns, known = known + SphereQuantity.MATERIAL, materials = names)
    }

    /** The same state, arrays shared, without materials. */
    internal fun withoutMaterials(): Snapshot = with(known = known - SphereQuantity.MATERIAL, materials = emptyList())

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
    public fun population(): Population = Population(PopulationColumns.joined(listOf(this)), materials)

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
            val optional = population.optional
            val now = boundary.at(time)
            return Snapshot(
                step,
                time,
                DoubleArray(3) { axis -> now.box.length(axis).let { if (it.isFinite()) it else Double.NaN } },
                BooleanArray(3) { now.repeats(it) },
                now.shear?.offset(time) ?: 0.0,
                IntArray(order.size) { population.id[order[it]] },
                Array(SphereQuantity.EXPORTED_WIDTH) { place ->
                    val column = population.column(place)
                    if (column === SphereQuantity.NONE) column else DoubleArray(order.size) { column[order[it]] }
                },
                now.shear?.normalAxis ?: 1,
                now.shear?.slideAxis ?: 0,
                SphereQuantity.EXPORTED.filterTo(HashSet()) {
                    (hasMass || it != SphereQuantity.MASS) && it.isIn(optional)
                },
                image(population, now, time, order),
                materials = population.materials,
                bound = if (population.bonds === Bonds.NONE) null else Bonds.partners(population, order),
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
