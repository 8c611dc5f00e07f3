package daphnis.drills

/**
 * What happens to the network of a run on three nodes: hosts 0 and 1 are the run and the first node, behind one bridge;
 * hosts 2 and 3 are the others, behind another.
 */
internal enum class NetworkFault(val words: String) {
    LINK_SHORT("a node's cable out for a moment"),
    LINK_LONG("a node's cable out for too long, then the node started anew"),
    HALVES("the cable between both halves out for too long"),
    RUN_SHORT("the run's cable out for a moment"),
    RUN_LONG("the run's cable out for too long"),
    NARROW("a node behind 1 Mbit/s"),
    RUN_NARROW("the run behind 1 Mbit/s"),
    LOSSY("delays, and lost packets"),
}
