package daphnis.core.scenario

import daphnis.core.Interval
import daphnis.core.input.ValueCheck
import daphnis.core.wave.ModeSums
import kotlin.math.abs

/** Checks how often a scenario's outputs are written. */
internal class OutputTimesCheck(
    private val scenario: Scenario,
    private val around: Surroundings,
    private val check: ValueCheck,
) {
    /** The same with intervals in units of time. */
    fun settled(): OutputSpec {
        val output = scenario.output
        val orbit = around.angularSpeed?.let { 2 * Math.PI / it }
        check.must("output.intervalUnit", output.intervalUnit != IntervalUnit.ORBIT || orbit != null) {
            "is orbit; it needs a frame of type hill"
        }
        for ((key, problem) in output.problems()) check.fail("output.$key", problem)
        val isWithModes = output.modesEvery > 0 || output.modesInterval != null
        ModeSums.problem(around.boundary)?.let { problem ->
            val key = if (output.modesInterval == null) "modesEvery" else "modesInterval"
            if (isWithModes) check.fail("output.$key", problem)
        }
        val settled = output.settled(orbit)
        for ((key, interval) in settled.intervals()) {
            val most = maxOf(abs(around.end), abs(scenario.startTime)) / interval
            check.must("output.$key", most <= Interval.MOST) {
                "is $interval in time; the run goes to time ${around.end}, $most intervals, and there can be " +
                    "${Interval.MOST}"
            }
        }
        return settled
    }
}
