package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.transport.Transport
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class MotionTest {
    @TempDir
    lateinit var directory: Path

    @Test
    fun `the balance of energies knows the potential energy where the series has a row for each of transport`() {
        for ((every, isKnown) in listOf(2 to true, 4 to false)) {
            val settings = listOf("untilOrbits=1", "timeStep.steps=200", "box.lengths=[60,60,20]") +
                listOf("output.transportEvery=2", "output.seriesEvery=$every")
            val path = directory.resolve("$every")
            Run.start(BuiltIn.scenario("self-gravity-wakes", settings), "wakes", path).use { it.execute() }
            val input = AnalysisInput.ofRun(path)
            val last = input.state(input.size - 1)
            val plain = Transport(input.transport!!, last.boundary.meanFlow!!.rate).energyBalance
            val found = Motion(input, 0.0, last).transport!!.energyBalance
            assertEquals(plain.mean, found.mean)
            if (isKnown) assertNotEquals(plain.error, found.error) else assertEquals(plain.error, found.error)
        }
    }
}
