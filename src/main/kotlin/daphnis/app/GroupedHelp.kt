package daphnis.app

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.output.HelpFormatter.ParameterHelp
import com.github.ajalt.clikt.output.MordantHelpFormatter
import com.github.ajalt.mordant.rendering.Widget

/**
 * The help of a command: first what it is given, then its options under [headings], those that a new user needs before
 * those of several machines. The library itself begins with options that are declared in a class of their own.
 *
 * @param headings with names of options, in the order in which they are shown; options that are in none come last
 */
internal class GroupedHelp(context: Context, private val headings: Map<String, List<String>>) :
    MordantHelpFormatter(context) {
    override fun collectParameterSections(parameters: List<ParameterHelp>): List<RenderedSection<Widget>> =
        renderArguments(parameters) + renderOptions(sorted(parameters)) + renderCommands(parameters)

    private fun sorted(parameters: List<ParameterHelp>): List<ParameterHelp> {
        val options = parameters.filterIsInstance<ParameterHelp.Option>()
        val placed = headings.flatMap { (heading, names) ->
            names.flatMap { name -> options.filter { name in it.names } }.map { it.copy(groupName = heading) }
        }
        val names = placed.flatMap { it.names }.toSet()
        return parameters - options.toSet() + placed + options.filter { it.names.none { name -> name in names } }
    }

    companion object {
        const val SEVERAL_MACHINES = "Several machines"
        private val MACHINES = SEVERAL_MACHINES to
            listOf("--nodes", "--cluster", "--host", "--secret-file", "--config", "--bind", "--insecure")
        private val WATCHING = "While it runs" to listOf("--live", "--quiet")

        private val COMMANDS = mapOf(
            "run" to mapOf(
                "Scenario and files" to listOf("--set", "--seed", "--from", "--out", "--force"),
                "Time" to listOf("--until", "--steps"),
                WATCHING,
                "Speed" to listOf("--engine", "--threads"),
                MACHINES,
            ),
            "resume" to mapOf(
                "Time and files" to listOf("--until", "--accept-loss"),
                WATCHING,
                SEVERAL_MACHINES to listOf("--nodes", "--threads") + (MACHINES.second - "--nodes"),
            ),
            "analyze" to mapOf(
                "States and files" to listOf(
                    "--scenario",
                    "--set",
                    "--time-step",
                    "--from",
                    "--frames",
                    "--out",
                    "--accept-loss",
                    "--quiet",
                ),
                "Streamlines" to listOf("--slabs", "--groups"),
                "Clusters" to listOf("--cluster-ratio"),
                "Occultation" to listOf(
                    "--elevation",
                    "--azimuth",
                    "--elevations",
                    "--azimuths",
                    "--footprint",
                    "--scan-path",
                    "--photons",
                    "--observed",
                ),
                "Brightness" to listOf(
                    "--brightness",
                    "--albedo",
                    "--phase-function",
                    "--light-elevation",
                    "--phase-angle",
                    "--phase-angles",
                    "--orders",
                    "--paths",
                    "--brightness-seed",
                    "--observed-brightness",
                ),
            ),
        )

        /** For the command called [name]. */
        fun of(context: Context, name: String): GroupedHelp = GroupedHelp(context, COMMANDS[name].orEmpty())
    }
}
