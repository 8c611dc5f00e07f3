package daphnis.actors.region

import daphnis.core.engine.islands.ClaimRule
import daphnis.core.engine.islands.IslandWorkers

/**
 * The work of one region, without any framework. Its owner calls [handle] with one command after the other, from one
 * thread at a time, and each call happens after the one before.
 */
public class Region(public val number: Int, private val map: RegionMap, private val workers: IslandWorkers) {
    private val worker = workers[number]
    private var locked = BooleanArray(0)
    private val ownSpheres = ClaimRule { map.regionOf(it) == number }
    private val lockedSpheres = ClaimRule { locked[map.regionOf(it)] }

    /** Called before each command; for tests that make a region fail or wait. */
    public var probe: (RegionCommand) -> Unit = {}

    /** Whether [serve] is running. */
    @Volatile
    internal var isAtWork: Boolean = false
        private set

    /**
     * Executes [command] and puts the result into [answers], whatever it is. Throws nothing, since a framework that
     * runs actors may lose what they throw.
     */
    internal fun serve(command: RegionCommand, answers: Answers) {
        isAtWork = true
        try {
            answers.put(handle(command))
        } catch (e: Throwable) {
            answers.fail(number, e)
        } finally {
            // After the answer, so that when neither this flag nor an answer is seen, none will come.
            isAtWork = false
        }
    }

    /** Executes [command] and returns the answer. Throws what goes wrong. */
    public fun handle(command: RegionCommand): RegionReply {
        probe(command)
        worker.claimRule = ownSpheres
        when (command.phase) {
            Phase.SHARE -> command.share!!.run(number)
            Phase.SEARCH -> map.forEachStretch(number) { from, to -> worker.searchStart(from, to) }
            Phase.PROPOSE -> workers.propose(number)
            Phase.WORK -> {
                worker.group()
                return RegionReply(number, command.phase, worker.processOwn())
            }
            Phase.GRANT -> {
                locked = command.locked
                worker.claimRule = lockedSpheres
                return RegionReply(number, command.phase, worker.process(command.islands))
            }
            Phase.CHECK -> worker.check()
            Phase.COMMIT -> worker.commit()
            Phase.LOOK_AHEAD -> worker.hintSuspects()
        }
        return RegionReply(number, command.phase)
    }
}
