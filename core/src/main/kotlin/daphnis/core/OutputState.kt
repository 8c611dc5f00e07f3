package daphnis.core

/**
 * The state of an [Output] in a checkpoint: arrays of numbers by name, kept to the bit.
 *
 * @param output what to call the output in messages
 */
public class OutputState internal constructor(private val output: String) {
    private val arrays = LinkedHashMap<String, Any>()

    /** Names of the arrays, in the order in which they were put. */
    public val names: Set<String> get() = arrays.keys

    /** Keeps a copy of [values] under [name] and replaces what was there. */
    public fun put(name: String, values: DoubleArray) {
        arrays[name] = values.copyOf()
    }

    /** Keeps a copy of [values] under [name] and replaces what was there. */
    public fun put(name: String, values: LongArray) {
        arrays[name] = values.copyOf()
    }

    /**
     * A copy of the numbers under [name].
     *
     * @throws IllegalStateException when there are none, or when they are whole numbers
     */
    public fun doubles(name: String): DoubleArray = (array(name) as? DoubleArray ?: wrong(name, "not doubles")).copyOf()

    /**
     * A copy of the numbers under [name].
     *
     * @throws IllegalStateException when there are none, or when they are not whole numbers
     */
    public fun longs(name: String): LongArray = (array(name) as? LongArray ?: wrong(name, "not longs")).copyOf()

    internal fun array(name: String): Any = arrays[name] ?: wrong(name, "missing")

    private fun wrong(name: String, what: String): Nothing =
        error("'$name' in the saved state of output '$output' is $what")
}
