package daphnis.core.run

import daphnis.core.input.InputException
import daphnis.core.scenario.GrowthSpec
import daphnis.core.scenario.OutputSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.TimeStepSpec
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject

/**
 * The differences between the scenario with which a run was made and the one that its directory holds now.
 *
 * @property essential changes that would make another run of it, one line each: all except those that affect no bit of
 *   a state, which are name and description, the end, that of growth too, engine and search, and how often outputs are written; but
 *   the intervals of outputs do where they shorten steps
 *
 * @property harmless the other changes, one line each
 */
internal class ScenarioChanges private constructor(
    private val then: OutputSpec,
    private val now: OutputSpec,
    private val isStepFree: Boolean = false,
) {
    val essential = ArrayList<String>()
    val harmless = ArrayList<String>()

    companion object {
        private val FREE = setOf("name", "description", "until", "untilOrbits", "engine", "search")
        private val GOALS = setOf(GrowthSpec::untilFillingFactor, GrowthSpec::untilPressure).map { "growth.${it.name}" }
        private val CHECKPOINTS =
            setOf(OutputSpec::checkpointEvery, OutputSpec::checkpointInterval).map { "output.${it.name}" }
        private const val LONGEST = 60
        private val MODES = "output.${OutputSpec::modes.name}"
        private val json = Json

        /**
         * @param then text of the scenario with which the run was made; null when it is not known, and then there are
         *   no changes
         */
        fun between(then: String?, now: Scenario): ScenarioChanges {
            if (then == null) return ScenarioChanges(now.output, now.output)
            val before = try {
                ScenarioJson.parse(then, "the checkpoint's scenario")
            } catch (e: InputException) {
                val problem = "cannot be compared with ${e.message}"
                return ScenarioChanges(now.output, now.output).apply { harmless += problem }
            }
            val isStepFree = now.timeStep.isChosen
            return ScenarioChanges(before.output, now.output, isStepFree).apply { compare("", tree(before), tree(now)) }
        }

        private fun tree(scenario: Scenario) = json.parseToJsonElement(ScenarioJson.write(scenario))
    }

    private fun compare(path: String, then: JsonElement?, now: JsonElement?) {
        if (then == now) return
        if (then is JsonObject && now is JsonObject) {
            for (key in then.keys + now.keys) compare(if (path.isEmpty()) key else "$path.$key", then[key], now[key])
        } else if (then is JsonArray && now is JsonArray && then.size == now.size) {
            for (k in then.indices) compare("$path[$k]", then[k], now[k])
        } else {
            val line = "$path: is ${words(now)}; the run was made with ${words(then)}"
            if (isFree(path)) harmless += "$line, which changes no state" else essential += line
        }
    }

    private fun isFree(path: String): Boolean {
        if (path.substringBefore('.') in FREE || path in CHECKPOINTS || path in GOALS) return true
        if (path == MODES) return ModesOutput.times(then).isNever
        val output = PeriodicOutputs.all.find { path == "output.${it.key}" || path == "output.${it.intervalKey}" }
            ?: return false
        if (isStepFree && output.intervalKey == path.removePrefix("output.")) return false
        return output.mayChange(output.times(then), output.times(now))
    }

    private fun words(value: JsonElement?) =
        value?.toString()?.let { if (it.length > LONGEST) it.take(LONGEST) + "…" else it } ?: "none"
}
