package daphnis.core.run

import daphnis.core.Interval
import daphnis.core.Output
import daphnis.core.scenario.OutputSpec
import daphnis.core.table.TableColumns
import kotlin.reflect.KProperty1

/**
 * An output that a run can have by a key of its [OutputSpec], declared once. Whatever makes it, knows its files,
 * compares its key or says what it costs, asks this.
 *
 * A further one is an `object` of this class in a file of this package, beside its [Output], and a key in [OutputSpec].
 * The compiler lists the objects of a sealed class, so [PeriodicOutputs] has it then. Tests make
 * `docs/reference/columns.md` of the meanings of its columns, and ask for a description of its key.
 *
 * @property name in the checkpoint and in messages; an output of a program cannot have it
 * @param property its key: a number of steps, 0 for never, or whether it is written after every step
 * @param interval its other key: an interval of time in place of the number of steps; null when it has none
 */
public sealed class PeriodicOutput(
    public val name: String,
    private val property: KProperty1<OutputSpec, Any>,
    private val interval: KProperty1<OutputSpec, Double?>? = null,
) {
    /** The key in a scenario's `output`. */
    public val key: String get() = property.name

    /** The key for an interval of time in place of a number of steps; null when it has none. */
    public val intervalKey: String? get() = interval?.name

    /** The tables that it writes into the run directory. */
    public open val tables: List<TableColumns> get() = emptyList()

    /** Names of its files in the run directory, which a new run removes. */
    public open val files: List<String> get() = tables.map { it.file }

    /** Name of the folder in the run directory that it fills with states, pictures or tables; null for none. */
    public open val folder: String? get() = null

    /** Whether it needs the record of collisions of each step. */
    internal open val readsCollisions: Boolean get() = false

    /** Whether sums over them are all that it needs of these. */
    internal open val sumsCollisions: Boolean get() = false

    /** When it is due; intervals of [spec] are in units of time. */
    public fun times(spec: OutputSpec): OutputTimes {
        interval?.get(spec)?.let { return OutputTimes(0, Interval(it)) }
        return when (val value = property.get(spec)) {
            is Int -> OutputTimes(value, null)
            true -> OutputTimes(1, null)
            else -> OutputTimes(0, null)
        }
    }

    /** Whether a resume may find it due at the times [now] where it was [then]. */
    internal open fun mayChange(then: OutputTimes, now: OutputTimes): Boolean = true

    /** What it writes at [times] in a run of [course] with [spheres] spheres; null for nothing. */
    public abstract fun cost(times: OutputTimes, course: Course, spheres: Int): OutputCost?

    /** The same for the keys of [spec], whose intervals are in units of time. */
    public open fun cost(spec: OutputSpec, course: Course, spheres: Int): OutputCost? =
        cost(times(spec), course, spheres)

    /**
     * The output, due at [times]; null when it then has nothing to do. Called before the first step of each start and
     * resume.
     */
    internal abstract fun make(times: OutputTimes, sums: StepSums, files: RunFiles): Output?

    override fun toString(): String = name
}

/**
 * What an output writes in a run.
 *
 * @property what in words, in the plural
 * @property count how many of these; null when only the run can tell, and then [what] says how much each takes
 * @property bytes on the disk, of all together; null with [count]
 */
public class OutputCost @JvmOverloads constructor(
    public val what: String,
    public val count: Double? = null,
    public val bytes: Double? = null,
)
