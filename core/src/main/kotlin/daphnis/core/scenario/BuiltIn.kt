package daphnis.core.scenario

import daphnis.core.input.InputException
import daphnis.core.input.Nearest
import java.io.IOException
import java.io.UncheckedIOException

/** The scenarios that come with daphnis, as the JSON text a user would start from. */
public object BuiltIn {
    /** The names, those of the paper first. The very first is what `daphnis run` runs when nothing is named. */
    @JvmStatic
    public val names: List<String> =
        listOf(
            "paper-figure-1", "paper-figure-2", "paper-figure-3", "elastic-gas", "cooling-gas", "driven-gas",
            "rough-gas", "mixture", "hard-discs", "vibrated-bed", "drum", "shear-cell", "ring-patch",
            "rough-ring", "perturbed-ring", "satellite-wake", "shepherds", "moonlet",
            "moonlet-walk", "overstability", "self-gravity-wakes",
            "crystal", "glass", "square-well", "wet-grains", "accretion", "effusion", "pouring",
        )

    /** The text of the scenario [name], with its comments; null when there is none. */
    @JvmStatic
    public fun text(name: String): String? {
        if (name !in names) return null
        val stream =
            BuiltIn::class.java.getResourceAsStream("/daphnis/scenarios/$name.json")
                ?: error("scenario $name is missing from the jar")
        return try {
            stream.use { String(it.readAllBytes(), Charsets.UTF_8) }
        } catch (e: IOException) {
            throw UncheckedIOException("scenario $name cannot be read from the jar", e)
        }
    }

    /** The scenario [name], with `path=value` [settings] applied. */
    @JvmStatic
    @JvmOverloads
    public fun scenario(name: String, settings: List<String> = emptyList()): Scenario = ScenarioJson.parse(
        text(name)
            ?: throw InputException(
                name,
                null,
                "no built-in scenario; ${Nearest.question(name, names)}known: ${names.joinToString()}",
            ),
        name,
        settings,
    )
}
