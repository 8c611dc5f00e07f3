package daphnis.drills

import java.util.Random

/**
 * Runs over node processes with small heaps, to which something is done at drawn moments: processes are killed,
 * stopped, told to end and started. Whatever it is, the files of the run must be those of one engine alone, byte by
 * byte.
 */
internal object NodesDrill : Drill {
    override val name = "nodes"
    override val what = "runs over node processes that are killed, stopped and joined by others; then file by file"
    override val cases = 40

    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally = inDirectory(name) { home ->
        val lost = ArrayList<String>()
        var strikes = 0
        for (case in 0..<cases) {
            // Each case has a stream of its own, so that what takes long in one does not change the next.
            val random = Random(seed * MANY + case)
            val scenario = NodesScenario.entries[((seed + case) % NodesScenario.entries.size).toInt()]
            val played = NodesCase(home, scenario, scenario.whole(home), random)
            val bad = played.play(1 + random.nextInt(MOST_STRIKES))
            strikes += played.strikes
            say("${if (bad.isEmpty()) "same" else "LOST"}: case $case, ${played.history}")
            for (line in bad) say(line)
            lost += bad.map { "case $case, ${played.history}: $it" }
        }
        Tally(cases, lost, listOf("$strikes strikes in $cases runs"))
    }

    private const val MANY = 1_000_003L
    private const val MOST_STRIKES = 3
}
