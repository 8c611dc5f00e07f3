package daphnis.core.run

import daphnis.core.Output
import daphnis.core.scenario.OutputSpec
import daphnis.core.table.TableColumns
import kotlin.math.floor
import kotlin.reflect.KProperty1

/**
 * An output that a run can have by a key of its [OutputSpec], declared once. Whatever makes it, knows its files,
 * compares its key or says what it costs, asks this.
 *
 * A further one is an `object` of this class in a file of this package, beside its [Output], and a key in [OutputSpec].
 * The compiler lists the objects of a sealed class, so [PeriodicOutputs] has it then. Tests ask for its rows in
 * `docs/scenario.md` and `docs/guide.md`.
 *
 * @property name in the checkpoint and in messages; an output of a program cannot have it
 * @param property its key: a number of steps, 0 for never, or whether it is written after every step
 */
public sealed class PeriodicOutput(public val name: String, private val property: KProperty1<OutputSpec, Any>) {
    /** The key in a scenario's `output`. */
    public val key: String get() = property.name

    /** The tables that it writes into the run directory. */
    public open val tables: List<TableColumns> get() = emptyList()

    /** Names of its files in the run directory, which a new run removes. */
    public open val files: List<String> get() = tables.map { it.file }

    /** Name of the folder in the run directory that it fills with states, pictures or tables; null for none. */
    public open val folder: String? get() = null

    /** Whether it needs the record of collisions of each step. */
    internal open val readsCollisions: Boolean get() = false

    /** How many steps lie between two times at which it is due; 0 for never. */
    public fun every(spec: OutputSpec): Int = when (val value = property.get(spec)) {
        is Int -> value
        true -> 1
        else -> 0
    }

    /** Whether a resume may find [now] steps in the scenario where there were [then]. */
    internal open fun mayChange(then: Int, now: Int): Boolean = true

    /**
     * What it writes when it is due [every] number of steps, in a run of [steps] steps of [spheres] spheres; null for
     * nothing.
     */
    public abstract fun cost(every: Int, steps: Double, spheres: Int): OutputCost?

    /**
     * The output, due [every] number of steps; null when it then has nothing to do. Called before the first step of
     * each start and resume.
     */
    internal abstract fun make(every: Int, sums: StepSums, files: RunFiles): Output?

    /** How often it is due in a run of [steps] steps, with the first state. */
    protected fun times(every: Int, steps: Double): Double = if (every == 0) 0.0 else floor(steps / every) + 1

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
