package daphnis.drills

/** What is done to a run over nodes. */
internal enum class NodesStrike(val words: String) {
    KILL_ONE("kill one"),
    KILL_TWO("kill two in a row"),
    KILL_ALL_BUT_ONE("kill all but one"),
    KILL_ALL("kill all, start one"),
    STOP_SHORT("stop one for a moment"),
    STOP_LONG("stop one for too long"),
    STOP_RUN_SHORT("stop the run for a moment"),
    STOP_RUN_LONG("stop the run for too long"),
    COME("one comes"),
    TERMINATE_ONE("SIGTERM to one"),
    TERMINATE_ALL_BUT_ONE("SIGTERM to all but one"),
    KILL_RUN("kill the run"),
    TERMINATE_RUN("SIGTERM to the run"),
}

/** When it is done. */
internal enum class NodesMoment(val words: String) {
    /** Some time after the process of the run was started: nodes join, the crew forms, the run directory is made. */
    EARLY("early"),

    /** When a drawn part of the rows is there. */
    AT_A_ROW("at a row"),

    /** When a file is half written. */
    HALF_A_FILE("half a file"),

    /** When nearly all rows are there, or some moments later. */
    LATE("late"),
}
