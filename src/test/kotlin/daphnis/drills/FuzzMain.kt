package daphnis.drills

import java.nio.file.Files
import java.nio.file.Path
import kotlin.system.exitProcess

/**
 * `scenario|foreign CASES SEED DIR`: a fuzz of any length; 1 when there are faults, whose files stay in the directory.
 */
fun main(args: Array<String>) {
    val (kind, cases, seed) = args
    val home = Files.createDirectories(Path.of(args[3]))
    val counts = if (kind == "scenario") {
        scenarioFuzz(cases.toInt(), seed.toLong(), home)
    } else {
        foreignFuzz(cases.toInt(), seed.toLong(), home)
    }
    println("$kind, seed $seed: $counts")
    exitProcess(if (counts.faults.isEmpty()) 0 else 1)
}
