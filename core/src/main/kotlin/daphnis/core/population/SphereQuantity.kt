package daphnis.core.population

/**
 * What is known of every sphere besides its id, declared once: each quantity with its columns, units, and what steps,
 * digest and files do with it. Columns have a **place**, counted through all quantities in the order of declaration.
 * Populations, rows, undo, checkpoints, digest, the files of others and messages between nodes go through this list, so
 * a new quantity is a line here and the code that computes with it. What pairs remember, which no column of numbers can
 * hold, goes beside it ([Bonds]).
 *
 * @property title as H5MD, VTK and Python call it
 * @property columns names of its columns, as tables, LAMMPS and Python's frames call them
 * @property xyz how extended XYZ calls it, lower case; daphnis writes the first
 * @property records names of its columns in a checkpoint, four letters each
 * @property dimension of its numbers
 * @property change what a step does to it
 * @property absent number of a sphere for which nothing was said
 * @property isPositive whether its numbers are sizes, > 0
 * @property isDigested whether the digest takes it in; all that a trajectory is compared by
 * @property isExported whether files other than checkpoints have it
 * @property isOptional whether there are spheres without it, whose columns of it are [NONE]
 */
internal enum class SphereQuantity(
    val title: String,
    val columns: List<String>,
    val xyz: List<String>,
    val records: List<String>,
    val dimension: Powers,
    val change: Change,
    val absent: Double = 0.0,
    val isPositive: Boolean = false,
    val isDigested: Boolean = false,
    val isExported: Boolean = true,
    val isOptional: Boolean = false,
) {
    POSITION(
        "position",
        words("x y z"),
        words("pos positions position"),
        words("POSX POSY POSZ"),
        Powers(length = 1),
        Change.MOVED,
        isDigested = true,
    ),
    VELOCITY(
        "velocity",
        words("vx vy vz"),
        words("velo vel velocity velocities"),
        words("VELX VELY VELZ"),
        Powers(length = 1, time = -1),
        Change.KICKED,
        isDigested = true,
    ),
    RADIUS(
        "radius",
        words("radius"),
        words("radius radii"),
        words("RADI"),
        Powers(length = 1),
        Change.NEVER,
        absent = 0.5,
        isPositive = true,
    ),
    MASS(
        "mass",
        words("mass"),
        words("mass masses"),
        words("MASS"),
        Powers(mass = 1),
        Change.NEVER,
        absent = 1.0,
        isPositive = true,
    ),

    /** Angular velocity, which rough spheres have. In Hill's frame it is relative to the frame. */
    SPIN(
        "angular_velocity",
        words("omegax omegay omegaz"),
        words("angular_velocity omega spin"),
        words("SPNX SPNY SPNZ"),
        Powers(time = -1),
        Change.KICKED,
        isDigested = true,
        isOptional = true,
    ),

    /** Number of what a sphere is made of, see [Population.materials]. */
    MATERIAL(
        "material",
        words("material"),
        words("material"),
        words("MATE"),
        Powers(),
        Change.NEVER,
        isOptional = true,
    ),

    /** See [Population.lastCollision]. */
    LAST_COLLISION(
        "last_collision",
        words("last_collision"),
        words("last_collision"),
        words("LAST"),
        Powers(time = 1),
        Change.NOTED,
        absent = Double.NEGATIVE_INFINITY,
        isExported = false,
    ),
    ;

    /** Place of its first column. */
    val place: Int get() = FIRST[ordinal]

    /** Places of its columns. */
    val places: IntRange get() = place until place + columns.size

    /** Its bit in the set of optional quantities that spheres have, see [of]; 0 for a quantity that all have. */
    val bit: Int get() = if (isOptional) 1 shl OPTIONAL.indexOf(this) else 0

    /** Whether spheres with the set [optional] have it. */
    fun isIn(optional: Int): Boolean = !isOptional || optional and bit != 0

    /** What a step does to a quantity. */
    enum class Change {
        /** Paths and collisions change it. */
        MOVED,

        /** Collisions change it, and forces too, in place, before the engine's part of a step. */
        KICKED,

        /** Nothing does. */
        NEVER,

        /** Collisions note their time in it, where that is asked for; it is counted from the end of the last step. */
        NOTED,
    }

    /** A product of powers of the units of length, time and mass. */
    class Powers(private val length: Int = 0, private val time: Int = 0, private val mass: Int = 0) {
        /** The product of three numbers in place of the units; one division at most. */
        fun of(length: Double, time: Double, mass: Double): Double {
            var above = 1.0
            var below = 1.0
            for ((number, power) in listOf(length to this.length, time to this.time, mass to this.mass)) {
                repeat(power) { above *= number }
                repeat(-power) { below *= number }
            }
            return above / below
        }

        /** The product in symbols, powers behind them as H5MD writes them: `m s-1`. */
        fun symbols(length: String, time: String, mass: String): String =
            listOf(mass to this.mass, length to this.length, time to this.time).filter { it.second != 0 }
                .joinToString(" ") { (symbol, power) -> if (power == 1) symbol else "$symbol$power" }

        /** The product in words, a power below behind a slash: `length/time`. */
        fun words(): String {
            fun side(sign: Int) = listOf("mass" to mass, "length" to length, "time" to time)
                .filter { it.second * sign > 0 }
                .joinToString(" ") { (word, power) -> if (power * sign == 1) word else "$word^${power * sign}" }
            return listOf(side(1).ifEmpty { "1" }, side(-1)).filter { it.isNotEmpty() }.joinToString("/")
        }
    }

    companion object {
        private val FIRST = entries.runningFold(0) { place, quantity -> place + quantity.columns.size }.toIntArray()

        /** Number of columns. */
        @JvmField
        val WIDTH: Int = FIRST.last()

        /** Quantities that are in files other than checkpoints. */
        @JvmField
        val EXPORTED: List<SphereQuantity> = entries.takeWhile { it.isExported }

        /** Number of their columns, which are the first. */
        @JvmField
        val EXPORTED_WIDTH: Int = EXPORTED.sumOf { it.columns.size }

        /** The column of a quantity that spheres do not have. There is no other of it, so it is known by reference. */
        @JvmField
        val NONE: DoubleArray = DoubleArray(0)

        private val OPTIONAL = entries.filter { it.isOptional }

        /** Bit of the set for spheres whose pairs remember something, see [Bonds]. */
        @JvmField
        val BONDED: Int = 1 shl OPTIONAL.size

        /** Number of sets of optional quantities, which are 0 until it. */
        @JvmField
        val SETS: Int = 2 * BONDED

        private val PRESENT = Array(SETS) { optional -> places { it.isIn(optional) } }

        /** The places of all columns of spheres that have the set [optional] of optional quantities. */
        fun present(optional: Int): IntArray = PRESENT[optional]

        /** The set of optional quantities that [spheres] have: the sum of their bits. */
        fun of(spheres: SphereColumns): Int {
            var set = 0
            for (k in FIRST_OPTIONAL.indices) if (spheres.column(FIRST_OPTIONAL[k]) !== NONE) set = set or (1 shl k)
            if (spheres.bonds !== Bonds.NONE) set = set or BONDED
            return set
        }

        private val FIRST_OPTIONAL = OPTIONAL.map { it.place }.toIntArray()

        private val OF_PLACE = entries.flatMap { quantity -> quantity.columns.map { quantity } }

        /** The quantity of the column at [place]. */
        fun at(place: Int): SphereQuantity = OF_PLACE[place]

        /** The places of all columns of quantities for which [holds]. */
        fun places(holds: (SphereQuantity) -> Boolean): IntArray =
            entries.filter(holds).flatMap { it.places }.toIntArray()
    }
}

private fun words(text: String) = text.split(' ')
