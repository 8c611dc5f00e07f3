package daphnis.drills

import daphnis.app.CommandResult
import daphnis.app.daphnis
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import kotlin.concurrent.thread
import kotlin.io.path.name

/** What a command made of a damaged run directory. */
internal enum class Verdict(val isGood: Boolean) {
    /** Exit code 0 and the same results as without damage. */
    SAME(true),

    /** Exit code 1 or 2, and one line that names the file. */
    TOLD(true),

    /** Exit code 0 and other results, and a line on the error stream that names the file. */
    NOTICED(true),

    /** Other results, or a refusal that does not name the file. */
    WRONG(false),

    /** A stack trace, more than one line, or a fault of the program's own. */
    TRACE(false),

    /** No end within minutes. */
    HANG(false),
}

/** One damaged directory and one command on it. */
internal class DamageCase(
    val number: Int,
    val file: String,
    val damage: String,
    val command: String,
    val verdict: Verdict,
    val said: String,
) {
    override fun toString() = "$number: $command, $file $damage: $verdict: $said"
}

/**
 * Damages copies of a run directory at drawn places, one file each, and looks at what `resume`, `compare`, `export` and
 * `analyze` make of them. Missing snapshots are none of it: runs may be thinned out.
 *
 * @param home an empty directory to work in
 * @param seed of the draws; the same seed draws the same cases
 */
internal class Damage(private val home: Path, seed: Long) {
    private val random = Random(seed)
    private val base = home.resolve("base")
    private val commands = RunCommands(base)
    private val files: List<String>
    private val expected: Map<String, Map<String, String>>

    init {
        commands.makeRun(home)
        files = Files.walk(base).use { all ->
            all.filter { Files.isRegularFile(it) }.map { base.relativize(it).toString() }.sorted().toList()
        }
        expected = RunCommands.NAMES.associateWith { name ->
            val copy = copy("expected-$name")
            val result = commands.run(name, copy)
            check(result.code == 0 && result.err.isEmpty()) { "$name of the whole run: ${result.err}" }
            commands.results(name, copy, result)
        }
    }

    /** Draws and judges [cases] cases. */
    fun run(cases: Int): List<DamageCase> = List(cases) { judge(it) }

    private fun copy(name: String): Path {
        val target = home.resolve(name)
        Files.walk(base).use { all ->
            for (file in all) {
                val place = target.resolve(base.relativize(file).toString())
                if (Files.isDirectory(file)) Files.createDirectories(place) else Files.copy(file, place)
            }
        }
        return target
    }

    private fun judge(number: Int): DamageCase {
        val directory = copy("case-$number")
        val file = files[random.nextInt(files.size)]
        val command = RunCommands.draw(random)
        val damage = Blow.draw(random, isSnapshot = file.endsWith(".h5")).strike(directory.resolve(file), random)
        var result: CommandResult? = null
        val worker = thread(isDaemon = true) { result = commands.run(command, directory) }
        worker.join(LONGEST_MILLISECONDS)
        val verdict = verdict(command, directory, Path.of(file).name, result)
        if (verdict.isGood) for (done in listOf(directory, Path.of("$directory-out"))) delete(done)
        return DamageCase(number, file, damage, command, verdict, result?.let { it.err.trim().take(300) }.orEmpty())
    }

    private fun verdict(command: String, directory: Path, file: String, result: CommandResult?): Verdict {
        if (result == null) return Verdict.HANG
        val lines = result.err.trim().lines()
        if ("\tat " in result.err || "fault of daphnis" in result.err) return Verdict.TRACE
        val isNamed = file in result.err
        if (result.code == 0) {
            val results = commands.results(command, directory, result)
            return when {
                results - file == expected.getValue(command) - file -> Verdict.SAME
                isNamed -> Verdict.NOTICED
                else -> Verdict.WRONG
            }
        }
        if (result.code !in 1..2 || !isNamed) return Verdict.WRONG
        return if (lines.size == 1) Verdict.TOLD else Verdict.TRACE
    }

    private fun delete(directory: Path) {
        if (Files.exists(directory)) {
            Files.walk(directory).use { all ->
                all.sorted(Comparator.reverseOrder()).forEach { Files.delete(it) }
            }
        }
    }

    companion object {
        private const val LONGEST_MILLISECONDS = 180_000L
    }
}
