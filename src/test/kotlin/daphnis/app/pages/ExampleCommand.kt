package daphnis.app.pages

import java.nio.file.Path

/**
 * A command of a page of examples as a test does it.
 *
 * @property words behind the program's name
 * @property output the file that takes what it prints, or null
 */
internal class ExampleCommand(val words: List<String>, val output: Path?) {
    companion object {
        /**
         * @param short options for each run, in place of what the page says of the same keys and of the end
         * @param folder the one in which the page is read, since a process cannot change its own
         * @return null where nothing is to be done: of other programs, and of those which serve a page until they end
         */
        fun of(command: ShellCommand, short: List<String>, folder: Path): ExampleCommand? {
            if (command.words.first().removePrefix("./") != "daphnis") return null
            val name = command.words.getOrNull(1) ?: return null
            if (name in setOf("view", "node") || command.words.any { it.startsWith("--live") }) return null
            val given = command.words.drop(2).map { placed(it, folder) }
            val words = if (name in setOf("run", "sweep")) shortened(given, short) + out(name, given, folder) else given
            return ExampleCommand(listOf(name) + words, command.output?.let { folder.resolve(it) })
        }

        private fun placed(word: String, folder: Path): String {
            val option = if (word.startsWith("--")) word.substringBefore('=', "") else ""
            val value = if (option.isEmpty()) word else word.substringAfter('=')
            if (!FILE.matches(value)) return word
            return (if (option.isEmpty()) "" else "$option=") + folder.resolve(value)
        }

        private fun out(name: String, given: List<String>, folder: Path): List<String> {
            if (given.any { it == "--out" || it.startsWith("--out=") }) return emptyList()
            val scenario = given.firstOrNull()?.takeUnless { it.startsWith("-") } ?: "run"
            val own = Path.of(scenario).fileName.toString().removeSuffix(".json")
            return listOf("--out", "${folder.resolve("runs").resolve(if (name == "sweep") "$own-sweep" else own)}")
        }

        private fun shortened(given: List<String>, short: List<String>): List<String> {
            val replaced = keys(short).toSet()
            val rest = ArrayList<String>()
            var k = 0
            while (k < given.size) {
                val next = if (given[k] in
                    PAIRS
                ) {
                    given.subList(k, minOf(k + 2, given.size))
                } else {
                    given.subList(k, k + 1)
                }
                if (keys(next).none { it in replaced }) rest += next
                k += next.size
            }
            return rest + short
        }

        /** What [words] are about: keys of settings, options, and the end of a run in any form. */
        private fun keys(words: List<String>): List<String> = words.mapIndexedNotNull { k, word ->
            val setting = if (words.getOrNull(k - 1) == "--set") word else word.removePrefix("--set=")
            val key = if (setting != word || words.getOrNull(k - 1) == "--set") setting.substringBefore('=') else word
            key.takeIf { word != "--set" && (key != word || word.startsWith("--")) }
        }.map { key -> if (key.substringBefore('=') in ENDS) "until" else key }

        private val FILE = Regex("""runs(?:/.*)?|(?:[\w-]+/)*[\w.-]+\.(?:json|csv|gif|mp4|webm|xyz|h5|txt)""")
        private val PAIRS = setOf("--set", "--until", "--steps", "--seeds", "--seed", "--out", "--threads", "--engine")
        private val ENDS = setOf("until", "untilOrbits", "--until", "--steps")
    }
}
