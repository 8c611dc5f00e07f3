package daphnis.core.table

/**
 * A column of a table that runs write, declared once for all code that writes, reads, draws or explains it.
 *
 * @property name as in the file's header, where its unit follows in brackets
 * @property meaning in a few words of Markdown, for the page of columns
 * @property dimension of its numbers, see [Dimension]
 * @property need whether a reader can do without it
 */
public class Column internal constructor(
    public val name: String,
    internal val meaning: String,
    public val dimension: String,
    public val need: Need,
) {
    override fun toString(): String = name
}

/** Whether a table can be used without a column. */
public enum class Need {
    /** A file without it is not such a table, and its cells are numbers, never empty. */
    NEEDED,

    /** Older files may lack it. */
    OPTIONAL,
}

/** Dimensions of quantities, in the words length, time and mass; empty for pure numbers. */
public object Dimension {
    public const val NUMBER: String = ""
    public const val LENGTH: String = "length"
    public const val TIME: String = "time"
    public const val MASS: String = "mass"
    public const val SPEED: String = "length/time"
    public const val ANGULAR_SPEED: String = "1/time"
    public const val SPEED_SQUARED: String = "length^2/time^2"
    public const val MOMENTUM: String = "mass length/time"
    public const val ENERGY: String = "mass length^2/time^2"

    /** Energy carried over a length, and a flux of energy times a volume. */
    public const val ENERGY_LENGTH: String = "mass length^3/time^2"
    public const val ENERGY_SPEED: String = "mass length^3/time^3"

    public const val WAVENUMBER: String = "1/length"

    /** Momentum carried over a length, Σ Δp δ, and angular momentum. */
    public const val ACTION: String = "mass length^2/time"
}
