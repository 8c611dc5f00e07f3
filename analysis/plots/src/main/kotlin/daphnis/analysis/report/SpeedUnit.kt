package daphnis.analysis.report

import daphnis.core.scenario.ScenarioParts

/**
 * In what the report tells speeds of impact: cm/s where a [scenario] says what its unit of speed is, by its units or by
 * a restitution law that is in cm/s; else that unit, called [unnamed].
 */
internal class SpeedUnit(scenario: ScenarioParts?, unnamed: String) {
    private val cmPerSecond = scenario?.cmPerSecond

    /** What a speed in the scenario's units is multiplied by. */
    val factor: Double = cmPerSecond ?: 1.0
    val name: String = if (cmPerSecond == null) unnamed else "cm/s"
}
