package daphnis.analysis.plot

/**
 * What speeds are relative to.
 *
 * @property name such as that of an engine
 * @property threads with which it worked
 * @property seconds that it took, positive
 */
public class Yardstick(public val name: String, public val threads: Int, public val seconds: Double) {
    /** In words: `serial`, `horizon on 2 threads`. */
    override fun toString(): String = if (threads == 1) name else "$name on $threads threads"
}
