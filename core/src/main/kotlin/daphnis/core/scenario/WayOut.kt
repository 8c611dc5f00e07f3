package daphnis.core.scenario

/**
 * What a caller who is refused can ask for instead.
 *
 * @property words as a part of the message
 */
public enum class WayOut(public val words: String) {
    /** Another directory for the run. */
    ANOTHER_DIRECTORY("give another directory"),

    /** Another directory for the run, or `force` of [daphnis.core.run.Run.start]. */
    REPLACE_RUN("give another directory, or replace the run in it"),

    /** `force`, which was given, does not go so far. */
    ONLY_RUNS_ARE_REPLACED("only runs are replaced"),

    /** `acceptLoss` of [daphnis.core.run.Run.resume]: tables are as they are. */
    RESUME_WITH_LOSS("bring the file back, or go on with what is there"),

    /** `acceptLoss` of [daphnis.core.run.Run.resume]: the run begins anew. */
    BEGIN_ANEW("bring one back, or run it again from its start"),

    /** `acceptLoss` of an analysis: files are as they are. */
    ANALYSE_WITH_LOSS("bring it back, or take what is there"),

    /** A scenario that writes snapshots. */
    WRITE_SNAPSHOTS("run with snapshots"),
}
