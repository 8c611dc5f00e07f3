package daphnis.analysis.report

import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject

/**
 * The parts of a [scenario] that decide its physics, each with all its values, defaults too. A key that is new in
 * scenarios is in it without being named here.
 */
internal class ScenarioWords(scenario: Scenario) {
    private val parts = Json.parseToJsonElement(ScenarioJson.write(scenario)).jsonObject

    /** Each part that the scenario has, by name. */
    fun rows(): List<Pair<String, String>> = (parts.keys - APART)
        .filter { parts.getValue(it) !is JsonNull }
        .map { it to JsonWords.text(withoutUnused(parts.getValue(it))) }

    /** Where a mass is given, the density beside it is a default that nobody reads. */
    private fun withoutUnused(part: JsonElement): JsonElement = when (part) {
        is JsonObject -> JsonObject(
            part.filterKeys { it != "density" || (part["mass"] ?: JsonNull) is JsonNull }
                .mapValues { withoutUnused(it.value) },
        )
        is JsonArray -> JsonArray(part.map(::withoutUnused))
        else -> part
    }

    private companion object {
        /** What the report says elsewhere, or what decides no physics. */
        val APART = setOf(
            "name", "description", "units", "box", "until", "untilOrbits", "search", "engine", "output", "firstBody",
        )
    }
}
