package daphnis.core.parallel

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class CoresTest {
    @Test
    fun `a job has no more cores than it was given, and none of the machine's beyond`() {
        fun cores(vararg environment: Pair<String, String>) = Cores.of(8, environment.toMap())
        assertEquals(8, cores())
        assertEquals(2, cores("SLURM_CPUS_PER_TASK" to "2"))
        assertEquals(3, cores("OMP_NUM_THREADS" to "3,2"))
        assertEquals(2, cores("OMP_NUM_THREADS" to "3", "SLURM_CPUS_PER_TASK" to " 2 "))
        assertEquals(8, cores("SLURM_CPUS_PER_TASK" to "64"))
        for (word in listOf("", "0", "-1", "many", "1.5")) assertEquals(8, cores("OMP_NUM_THREADS" to word)) { word }
    }
}
