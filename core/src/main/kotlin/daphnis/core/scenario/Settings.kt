package daphnis.core.scenario

import daphnis.core.input.Nearest
import daphnis.core.input.wrongArgument
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * Replaces keys of a scenario's tree by `path=value` settings, as given on the command line. A path is what messages
 * call a key: names with dots between, and `[k]` after the name of a list, from 0: `timeStep.dt`,
 * `forces[0].massRatio`, `box.lengths[2]`. `[+]` is a new entry at the end of a list, which may not be there yet. A
 * value is JSON, or otherwise a string.
 */
internal object Settings {
    fun apply(tree: JsonElement, settings: List<String>): JsonElement {
        var changed = tree
        val keys = settings.map { it.substringBefore('=') }
        if (UNTIL in keys && ORBITS in keys) {
            throw wrongArgument(SETTINGS, ORBITS, "is given together with $UNTIL; one of the two is enough")
        }
        for (setting in settings) {
            changed = set(changed, setting)
            // A length given in orbits replaces the time that the scenario had, since `until` has priority over
            // `untilOrbits`.
            if (setting.substringBefore('=') == ORBITS) changed = JsonObject((changed as JsonObject) - UNTIL)
            changed = withoutCounterpart(changed, setting.substringBefore('='), keys)
        }
        return changed
    }

    /** How often an output is written, in steps or in time, replaces what the scenario had in the other. */
    private fun withoutCounterpart(tree: JsonElement, path: String, paths: List<String>): JsonElement {
        if (!path.startsWith(OUTPUT)) return tree
        val key = path.removePrefix(OUTPUT)
        val other = OutputSpec.counterpart(key) ?: return tree
        if (OUTPUT + other in paths) {
            throw wrongArgument(SETTINGS, path, "is given together with $OUTPUT$other; ${OutputSpec.ONE_OF_TWO}")
        }
        val fields = tree as JsonObject
        val output = fields["output"] as? JsonObject ?: return tree
        return JsonObject(fields + ("output" to JsonObject(output - other)))
    }

    private fun set(tree: JsonElement, setting: String): JsonElement {
        val path = setting.substringBefore('=')
        if ('=' !in setting || path.isBlank()) {
            throw wrongArgument(SETTINGS, setting, "must have the form path=value, such as timeStep.dt=0.05")
        }
        return put(tree, steps(path, setting), 0, value(path, setting.substringAfter('=')), setting)
    }

    private fun value(path: String, text: String): JsonElement = try {
        Json.parseToJsonElement(text).let {
            if (it.isDeeperThan(MOST_LEVELS)) throw tooDeep(path)
            RepeatedKey.find(text)?.let { twice -> throw wrongArgument(SETTINGS, path, "has ${twice.path} twice") }
            if (it is JsonPrimitive && !it.isString && !isLiteral(it.content)) {
                JsonPrimitive(text)
            } else {
                it
            }
        }
    } catch (e: SerializationException) {
        JsonPrimitive(text)
    } catch (e: StackOverflowError) {
        throw tooDeep(path)
    }

    private fun tooDeep(path: String) = wrongArgument(SETTINGS, path, "is nested too deeply")

    /** Whether there are more than so many [levels] of arrays and objects in one another; does not look further. */
    private fun JsonElement.isDeeperThan(levels: Int): Boolean = when (this) {
        is JsonArray -> levels == 0 || any { it.isDeeperThan(levels - 1) }
        is JsonObject -> levels == 0 || values.any { it.isDeeperThan(levels - 1) }
        else -> false
    }

    private fun isLiteral(text: String) =
        text == "true" || text == "false" || text == "null" || text.toDoubleOrNull() != null

    /** The way down the tree: `forces[0].x` is forces, [0], x. */
    private fun steps(path: String, setting: String): List<String> = path.split('.').flatMap { part ->
        val found = PART.matchEntire(part)
            ?: throw wrongArgument(
                SETTINGS,
                setting,
                "'$part' is not a key; for x of the first entry of a list write forces[0].x, " +
                    "and quote it for the shell",
            )
        listOf(found.groupValues[1]) + INDEX.findAll(found.groupValues[2]).map { it.value }
    }

    private fun put(
        tree: JsonElement?,
        steps: List<String>,
        at: Int,
        value: JsonElement,
        setting: String,
    ): JsonElement {
        if (at == steps.size) return value
        val step = steps[at]
        val here = steps.take(at).joinToString(".").replace(".[", "[")
        if (step.startsWith('[')) {
            val isNew = step == NEW
            val isAbsent = tree == null || tree is JsonNull
            val list = tree as? JsonArray
                ?: JsonArray(emptyList()).takeIf { isNew && isAbsent }
                ?: throw wrongArgument(SETTINGS, setting, noList(here, step, isAbsent))
            if (isNew) return JsonArray(list + put(null, steps, at + 1, value, setting))
            val k = step.trim('[', ']').toIntOrNull()?.takeIf { it in list.indices }
                ?: throw wrongArgument(
                    SETTINGS,
                    setting,
                    "$here has ${entries(list.size)}, so it has no $step; ${addition(here)}",
                )
            return JsonArray(
                list.mapIndexed { i, entry ->
                    if (i == k) put(entry, steps, at + 1, value, setting) else entry
                },
            )
        }
        if (tree is JsonArray) {
            throw wrongArgument(
                SETTINGS,
                setting,
                "$here is a list; write $here[0] for its first entry, $here$NEW for one more",
            )
        }
        if (tree != null && tree !is JsonObject) {
            throw wrongArgument(SETTINGS, setting, "'$step' is looked up inside something that is not an object")
        }
        val fields = tree ?: JsonObject(emptyMap())
        return JsonObject(fields + (step to put(fields[step], steps, at + 1, value, setting)))
    }

    /** One that the scenario could have can be begun; of one that no scenario has, the name may be mistyped. */
    private fun noList(here: String, step: String, isAbsent: Boolean): String {
        val problem = "$here is not a list in this scenario, so it has no $step"
        return when {
            !isAbsent || '.' in here -> problem
            here in LISTS -> "$problem; ${addition(here)}"
            else -> "$problem; ${Nearest.question(here, LISTS).trim()}".removeSuffix("; ")
        }
    }

    private fun addition(list: String) = if (list in LISTS) "$list$NEW={…} adds one" else "$list$NEW adds one"

    private fun entries(n: Int) = when (n) {
        0 -> "no entry"
        1 -> "1 entry, [0]"
        else -> "$n entries, [0] to [${n - 1}]"
    }

    /** The lists of a scenario that it can do without. */
    private val LISTS = listOf("forces", "bodies")
    private const val SETTINGS = "settings"

    /** More than any scenario has; few enough for the stack of all that reads it. */
    private const val MOST_LEVELS = 64
    private const val OUTPUT = "output."
    private const val UNTIL = "until"
    private const val ORBITS = "untilOrbits"
    private const val NEW = "[+]"
    private val PART = Regex("""([^\[\]]+)((?:\[(?:\d+|\+)])*)""")
    private val INDEX = Regex("""\[(?:\d+|\+)]""")
}
