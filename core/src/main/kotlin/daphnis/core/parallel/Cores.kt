package daphnis.core.parallel

/** How many cores this process is meant to use. */
public object Cores {
    private val BY_ENVIRONMENT = listOf("SLURM_CPUS_PER_TASK", "OMP_NUM_THREADS")

    /**
     * The cores that the machine, a container's quota and the set of cores of this process leave it, and no more than
     * `SLURM_CPUS_PER_TASK` and `OMP_NUM_THREADS`, by which batch systems and users say how many threads a job has.
     */
    @JvmStatic
    public val ofJob: Int by lazy { of(Runtime.getRuntime().availableProcessors(), System.getenv()) }

    /** [available] cores, or the fewer that [environment] says. What is no number from 1 on counts for nothing. */
    internal fun of(available: Int, environment: Map<String, String>): Int {
        // A list of numbers is for nested loops, of which there are none here.
        val said = BY_ENVIRONMENT.mapNotNull { environment[it]?.substringBefore(',')?.trim()?.toIntOrNull() }
        return said.filter { it >= 1 }.fold(available, ::minOf)
    }
}
