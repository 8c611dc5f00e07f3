package daphnis.core.population

/**
 * What is known of every sphere besides its id, declared once: each quantity with its columns, units, and what steps,
 * digest and files do with it. Columns have a **place**, counted through all quantities in the order of declaration.
 * Populations, rows, undo, checkpoints, digest, the files of others and messages between nodes go through this list, so
 * a new quantity is a line here and the code that computes with it.
 *
 * @property title as H5MD, VTK and Python call it
 * @property columns names of its columns, as tables, LAMMPS and Python's frames call them
 * @property xyz how extended XYZ calls it
 * @property records names of its columns in a checkpoint, four letters each
 * @property dimension of its numbers: powers of length, time and mass
 * @property change what a step does to it
 * @property initial number of a sphere for which nothing was said; NaN where it must be said
 * @property isDigested whether the digest takes it in; all that a trajectory is compared by
 * @property isExported whether files other than checkpoints have it
 */
internal enum class SphereQuantity(
    val title: String,
    val columns: List<String>,
    val xyz: String,
    val records: List<String>,
    val dimension: Powers,
    val change: Change,
    val initial: Double = Double.NaN,
    val isDigested: Boolean = false,
    val isExported: Boolean = true,
) {
    POSITION("position", words("x y z"), "pos", words("POSX POSY POSZ"), Powers(1, 0, 0), Change.MOVED, 0.0, true),
    VELOCITY(
        "velocity",
        words("vx vy vz"),
        "velo",
        words("VELX VELY VELZ"),
        Powers(1, -1, 0),
        Change.KICKED,
        0.0,
        true,
    ),
    RADIUS("radius", words("radius"), "radius", words("RADI"), Powers(1, 0, 0), Change.NEVER),
    MASS("mass", words("mass"), "mass", words("MASS"), Powers(0, 0, 1), Change.NEVER),

    /** See [Population.lastCollision]. */
    LAST_COLLISION(
        "last_collision",
        words("last_collision"),
        "last_collision",
        words("LAST"),
        Powers(0, 1, 0),
        Change.NOTED,
        Double.NEGATIVE_INFINITY,
        isExported = false,
    ),
    ;

    /** Place of its first column. */
    val place: Int get() = FIRST[ordinal]

    /** Places of its columns. */
    val places: IntRange get() = place until place + columns.size

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

    /** Powers of the units of length, time and mass. */
    class Powers(val length: Int, val time: Int, val mass: Int) {
        /** The factor by which numbers grow when the units are so much smaller. */
        fun factor(length: Double, time: Double, mass: Double): Double =
            power(length, this.length) * power(time, this.time) * power(mass, this.mass)

        private fun power(factor: Double, exponent: Int): Double = when (exponent) {
            0 -> 1.0
            1 -> factor
            -1 -> 1 / factor
            else -> Math.pow(factor, exponent.toDouble())
        }
    }

    companion object {
        private val FIRST = entries.runningFold(0) { place, quantity -> place + quantity.columns.size }.toIntArray()

        /** Number of columns. */
        @JvmField
        val WIDTH: Int = FIRST.last()

        /** Quantities that are in files other than checkpoints. */
        @JvmField
        val EXPORTED: List<SphereQuantity> = entries.filter { it.isExported }

        private val OF_PLACE = entries.flatMap { quantity -> quantity.columns.map { quantity } }

        /** The quantity of the column at [place]. */
        fun at(place: Int): SphereQuantity = OF_PLACE[place]

        /** The places of all columns of quantities for which [holds]. */
        fun places(holds: (SphereQuantity) -> Boolean): IntArray =
            entries.filter(holds).flatMap { it.places }.toIntArray()
    }
}

private fun words(text: String) = text.split(' ')
