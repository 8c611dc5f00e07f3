package daphnis.cluster.downing

/**
 * What to do when processes of the cluster have been unreachable for some time. The spheres are safe with the process
 * of the run, so the part with the run goes on, however small it is. Where the run itself cannot be reached, or there
 * is none, the greater part of the nodes stays together and waits for another run; the smaller part ends. Parts of one
 * size both stay: nobody can tell a node that has died from one that was cut off, and without a run nothing can go
 * wrong.
 */
internal object Parting {
    /**
     * @property isRun whether it is the process of a run, otherwise it is a node
     * @property age a smaller number is that of an older member
     */
    data class Seen(val isRun: Boolean, val age: Int, val isReachable: Boolean)

    enum class Decision { OTHERS_GO, SELF_GOES }

    /** Decides for a process that sees [members], itself included. */
    fun decide(members: List<Seen>): Decision {
        val run = members.filter { it.isRun }.minByOrNull { it.age }
        if (run != null && run.isReachable) return Decision.OTHERS_GO
        val nodes = members.filter { !it.isRun }
        val here = nodes.count { it.isReachable }
        return if (2 * here >= nodes.size) Decision.OTHERS_GO else Decision.SELF_GOES
    }
}
