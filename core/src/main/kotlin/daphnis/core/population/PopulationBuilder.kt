package daphnis.core.population

/**
 * The columns of a [Population] by their names, from [Population.builder]. It needs positions, radii and masses.
 * [build] copies the arrays, so that one of zeros can be given several times; the constructor takes them as they are.
 *
 * ```java
 * Population population = Population.builder()
 *     .positions(x, y, z)
 *     .velocities(vx, vy, vz)
 *     .radius(0.5)
 *     .mass(1.0)
 *     .build();
 * ```
 */
public class PopulationBuilder internal constructor() {
    private var positions: Array<DoubleArray>? = null
    private var velocities: Array<DoubleArray>? = null
    private var radii: Column? = null
    private var masses: Column? = null
    private var spins: Array<DoubleArray>? = null
    private var ids: IntArray? = null
    private var material: Pair<IntArray, List<String>>? = null

    /** A column of [n] numbers. */
    private fun interface Column {
        fun of(n: Int): DoubleArray
    }

    /** Positions, in units of length. */
    public fun positions(x: DoubleArray, y: DoubleArray, z: DoubleArray): PopulationBuilder =
        apply { positions = arrayOf(x, y, z) }

    /** Velocities, in units of length per unit of time; 0 unless given. */
    public fun velocities(vx: DoubleArray, vy: DoubleArray, vz: DoubleArray): PopulationBuilder =
        apply { velocities = arrayOf(vx, vy, vz) }

    /** The same radius for all spheres, > 0, in units of length. */
    public fun radius(radius: Double): PopulationBuilder = apply { radii = Column { n -> DoubleArray(n) { radius } } }

    /** A radius for each sphere. */
    public fun radii(radii: DoubleArray): PopulationBuilder = apply { this.radii = Column { radii.copyOf() } }

    /** The same mass for all spheres, > 0. */
    public fun mass(mass: Double): PopulationBuilder = apply { masses = Column { n -> DoubleArray(n) { mass } } }

    /** A mass for each sphere. */
    public fun masses(masses: DoubleArray): PopulationBuilder = apply { this.masses = Column { masses.copyOf() } }

    /** Angular velocities, radians per unit of time, for rough spheres; none unless given. */
    public fun spins(wx: DoubleArray, wy: DoubleArray, wz: DoubleArray): PopulationBuilder =
        apply { spins = arrayOf(wx, wy, wz) }

    /** The number of the material of each sphere and the names by number, see [Population.withMaterial]; none unless given. */
    public fun materials(material: IntArray, names: List<String>): PopulationBuilder =
        apply { this.material = material to names }

    /** Distinct ids, ≥ 0; 0, 1, 2, … unless given. */
    public fun ids(ids: IntArray): PopulationBuilder = apply { this.ids = ids }

    /**
     * A population with arrays of its own.
     *
     * @throws IllegalArgumentException when a column is missing, or for what [Population] refuses
     */
    public fun build(): Population {
        val (x, y, z) = copied(requireNotNull(positions) { "the spheres have no positions; give positions(x, y, z)" })
        val n = x.size
        val (vx, vy, vz) = velocities?.let(::copied) ?: Array(AXES) { DoubleArray(n) }
        val radius = requireNotNull(radii) { "the spheres have no radii; give radius(…) or radii(…)" }.of(n)
        val mass = requireNotNull(masses) { "the spheres have no masses; give mass(…) or masses(…)" }.of(n)
        val smooth = Population(x, y, z, vx, vy, vz, radius, mass, ids?.copyOf() ?: IntArray(n) { it })
        val spheres = spins?.let { (wx, wy, wz) -> smooth.withSpin(wx, wy, wz) } ?: smooth
        return material?.let { (numbers, names) -> spheres.withMaterial(numbers, names) } ?: spheres
    }

    private fun copied(columns: Array<DoubleArray>) = Array(AXES) { columns[it].copyOf() }

    private companion object {
        const val AXES = 3
    }
}
