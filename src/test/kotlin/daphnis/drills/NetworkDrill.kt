package daphnis.drills

import java.util.Random

/**
 * A run over nodes on hosts of their own, whose network fails: network namespaces on this machine. Without the right to
 * make some, nothing is tried.
 */
internal object NetworkDrill : Drill {
    override val name = "network"
    override val what = "cables taken out, narrow and lossy links between the processes of a run over nodes; needs root"
    override val cases = 16

    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally = inDirectory(name) { home ->
        Namespaces.refusal()?.let {
            return@inDirectory Tally(0, emptyList(), listOf("skipped: no network namespaces here: $it"))
        }
        val lost = ArrayList<String>()
        val notes = ArrayList<String>()
        var tried = 0
        for (case in 0..<cases) {
            val fault = NetworkFault.entries[((seed - 1 + case) % NetworkFault.entries.size).toInt()]
            val random = Random(seed * MANY + case)
            val bad = Namespaces(HOSTS, HOSTS / 2).use { NetworkCase(home, it, fault, random).play() }
            if (bad == null) {
                notes += "skipped: ${fault.words}: this machine cannot do that"
                continue
            }
            tried++
            say("${if (bad.isEmpty()) "same" else "LOST"}: case $case, ${fault.words}")
            for (line in bad) say(line)
            lost += bad.map { "case $case, ${fault.words}: $it" }
        }
        Tally(tried, lost, notes)
    }

    /** The run and three nodes. */
    private const val HOSTS = 4
    private const val MANY = 1_000_003L
}
