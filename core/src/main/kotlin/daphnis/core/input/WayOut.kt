package daphnis.core.input

/**
 * What a caller can ask for instead after a refusal, or to be told more than a notice says is known.
 *
 * @property words as a part of the message
 */
public enum class WayOut(public val words: String) {
    /** Another directory for the run. */
    ANOTHER_DIRECTORY("give another directory"),

    /** Another directory for the run, or `force` of [daphnis.core.run.Run.start]. */
    REPLACE_RUN("give another directory, or replace the run in it"),

    /** `force`, which was given, does not allow that. */
    ONLY_RUNS_ARE_REPLACED("only runs are replaced"),

    /** `acceptLoss` of [daphnis.core.run.Run.resume]: damaged tables are accepted as they are. */
    RESUME_WITH_LOSS("bring the file back, or continue with what is there"),

    /** `acceptLoss` of [daphnis.core.run.Run.resume]: the run starts again. */
    BEGIN_ANEW("bring one back, or run it again from its start"),

    /** `acceptLoss` of an analysis: damaged files are accepted as they are. */
    ANALYSE_WITH_LOSS("bring it back, or accept what is there"),

    /** TLS in a file of settings, or `insecure` of a cluster, where nobody else is on the network. */
    TLS_OR_INSECURE("set daphnis.cluster.tls in a settings file, or set insecure where the network is trusted"),

    /** The end of the process that is at work in the directory. */
    AWAIT_OTHER("wait for its end"),

    /** A scenario that writes snapshots. */
    WRITE_SNAPSHOTS("run with snapshots"),

    /** The time of a step, of a file that numbers its steps only. */
    GIVE_TIME_STEP("give the time of a step"),

    /** A scenario, of a file that does not say what it would. */
    GIVE_SCENARIO("give its scenario"),
}
