package daphnis.drills

import kotlin.system.exitProcess

/** All drills there are. */
internal val drills: List<Drill> = listOf(
    KillDrill,
    LiveDirectoryDrill,
    SmallHeapDrill,
    SoakDrill,
    DamageDrill,
    ScenarioFuzzDrill,
    ForeignFuzzDrill,
    ThrowDrill,
    NodesDrill,
    NetworkDrill,
    CliffDrill,
)

/** `drill NAME [CASES [SEED]]`: tells every case, then what was tried and lost; exit code 1 when anything was. */
fun main(args: Array<String>) {
    val drill = drills.find { it.name == args.firstOrNull() }
    val cases = args.getOrNull(1)?.toIntOrNull() ?: drill?.cases
    val seed = if (args.size > 2) args[2].toLongOrNull() else 1L
    if (drill == null || cases == null || cases < 1 || seed == null || args.size > 3) {
        System.err.println("usage: tools/drills/drill NAME [CASES [SEED]]")
        for (known in drills) {
            System.err.println(
                "  %-8s %s (%d cases)".format(java.util.Locale.ROOT, known.name, known.what, known.cases),
            )
        }
        exitProcess(2)
    }
    val begin = System.nanoTime()
    val tally = drill.run(cases, seed) { println(it) }
    for (note in tally.notes) println(note)
    for (line in tally.lost) println("LOST: $line")
    println(
        "${drill.name}: ${tally.tried} tried with seed $seed in ${(System.nanoTime() - begin) / 1_000_000_000} s, " +
            "${tally.lost.size} lost",
    )
    exitProcess(if (tally.lost.isEmpty()) 0 else 1)
}
