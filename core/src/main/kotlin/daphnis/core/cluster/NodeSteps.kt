package daphnis.core.cluster

import daphnis.core.RemoteParts
import daphnis.core.RemoteSteps
import daphnis.core.collision.CollisionCounters
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.Cores
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import java.time.Duration

/**
 * Steps of a simulation whose spheres are held by the nodes of a [Fleet]. This process, the leader, has the state at
 * the start and fetches it from time to time: when somebody asks for the population, and for safety ([CopyClock]). Sums
 * over the spheres are taken by the nodes ([CrewSums]). When a node is lost, the others begin again from the state that
 * was fetched last, and make the same steps again. They end in the same bits, and nobody but the log notices. A node
 * that has come takes its share from the next step on.
 *
 * @param setup of the scenario, as the run has resolved it
 * @param state the population, whose spheres are brought home into it
 * @param patience how long to wait when no node is left
 * @param log is told, in a line each, what a user should know
 */
internal class NodeSteps(
    private val fleet: Fleet,
    setup: ScenarioSetup,
    private val state: Population,
    private val forcing: CollisionForcing,
    startTime: Double,
    startStep: Long,
    private val patience: Duration,
    private val copies: CopyClock,
    private val log: (String) -> Unit,
) : RemoteSteps {
    private val scenario = ScenarioJson.write(setup.scenario)
    private val carried = setup.carried
    private val sums = CrewSums(setup)
    private val exchanged = setup.sources?.sums

    @Volatile
    private var crew: Crew? = null

    /** The state at home is that after this step. */
    private var homeStep = startStep
    private var homeTime = startTime
    private var homeCarried = carried.numbers

    /** The last step that stands. */
    private var step = startStep
    private var time = startTime
    private val before = CollisionCounters()
    private var timeBefore = startTime
    private var carriedBefore = homeCarried
    private var isCarried = false

    @Volatile
    private var isClosed = false

    private val report = CrewReport()

    /** Why the last crew has ended, until another works, and where it begins. */
    private var loss: String? = null
    private var lossStep = 0L

    /** For sums over spheres that are at home. */
    private val handler = FixedPool(Cores.ofJob)
    private val gate = ClosableLoop(ParallelLoop(handler, LoopStrategy.DYNAMIC), CollisionEngine.CLOSED)
    override val name: String get() = "cluster"
    override val loop: RangeLoop get() = gate

    /** Threads of the nodes of the last crew; 0 before the first. */
    override var threads: Int = 0
        private set

    override fun begin() {
        before.set(forcing.counters)
        timeBefore = time
        carriedBefore = carried.numbers
        isCarried = false
    }

    override fun carry(start: Double, settle: (duration: Double) -> Double, at: () -> String) {
        if (crew?.hasFailed == true) dismiss()
        // Here, where nothing is carried yet: when a copy cannot be had, the step before stands.
        if (copies.isDue()) bringHome()
        val done = withCrew {
            inviteNew(it)
            it.step()
        }
        isCarried = true
        step++
        val end = settle(done[0].duration)
        check(end == done[0].time) { "the nodes are at time ${done[0].time} after ${at()}" }
        forcing.counters.addParts(done.map { it.counted })
        forcing.record?.takeAll(done)
        forcing.tally?.let { tally ->
            tally.clear()
            for (part in done) tally.merge(part.tally!!)
        }
        exchanged?.let { sums ->
            sums.clear()
            for (part in done) sums.merge(part.exchanged!!)
        }
        report.add(done)
        time = end
        carried.numbers = done[0].carried
    }

    override fun commit() {
        isCarried = false
    }

    override fun takeBack() {
        if (isCarried) {
            check(homeStep < step) { "the state after step $step has been fetched" }
            step--
            time = timeBefore
            dismiss()
        }
        isCarried = false
        carried.numbers = carriedBefore
        forcing.counters.set(before)
        forcing.record?.clear()
        forcing.tally?.clear()
        exchanged?.clear()
    }

    override fun bringHome() {
        if (homeStep == step) return
        withCrew { fetch(it) }
    }

    override fun sumElsewhere(take: (RemoteParts) -> Unit): Boolean {
        if (homeStep == step) return false
        withCrew { crew -> sums.with(crew, take) }
        return true
    }

    private fun fetch(crew: Crew) {
        copies.measure { crew.gather(state) }
        homeStep = crew.step
        homeTime = time
        homeCarried = carried.numbers
    }

    /** When nodes have come, the crew ends here, and all that are there now begin. */
    private fun inviteNew(crew: Crew) {
        val all = fleet.nodes()
        val come = all.count { it !in crew.nodes }
        if (come == 0) return
        if (homeStep != step) fetch(crew)
        log("${count(come)} ${if (come == 1) "has" else "have"} come")
        throw MailClosedException(RENEWED)
    }

    /** Does [act] with a crew that has made [step] steps; again with another one when nodes are lost. */
    private fun <T> withCrew(act: (Crew) -> T): T {
        var inVain = 0
        var ended = emptyList<FleetNode>()
        // What is left of a step that has failed is not the same on all nodes, so they cannot make it again.
        if (crew?.let { it.hasFailed && it.step < step } == true) dismiss()
        while (true) {
            requireOpen()
            try {
                // A node that is lost is there until all have noticed.
                if (inVain > 1) Thread.sleep(PAUSE_MILLIS)
                val crew = crew ?: begin(present())
                while (crew.step < step) {
                    crew.step()
                    noteLoss(crew)
                }
                return act(crew).also { noteLoss(crew) }
            } catch (e: InterruptedException) {
                // Some answers of the nodes have not been taken.
                dismiss()
                Thread.currentThread().interrupt()
                throw IllegalStateException("interrupted while waiting for nodes", e)
            } catch (e: MailClosedException) {
                val nodes = crew?.nodes.orEmpty()
                dismiss()
                requireOpen()
                if (e.message == RENEWED) continue
                if (loss == null) {
                    loss = e.message
                    lossStep = homeStep
                }
                inVain = if (nodes == ended) inVain + 1 else 1
                ended = nodes
                if (inVain == MOST_IN_VAIN) {
                    throw FleetException("${count(nodes.size)} have begun $inVain times and ended: ${e.message}")
                }
            } catch (e: Throwable) {
                // Such as an interruption: answers that nobody waits for would be taken for others.
                if (crew?.mustEnd == true) dismiss()
                throw e
            }
        }
    }

    private fun requireOpen() = check(!isClosed) { "the simulation is closed" }

    /** Tells of a loss, once others work. Until all have noticed it, several crews may have come to nothing. */
    private fun noteLoss(crew: Crew) {
        val goOn = if (crew.nodes.size == 1) "continues" else "continue"
        log("${loss ?: return}; ${count(crew.nodes.size)} $goOn from step $lossStep")
        loss = null
    }

    /** The nodes that are there; waits for one, since a lost one may be started again. */
    private fun present(): List<FleetNode> {
        val why = loss?.let { "$it; " }.orEmpty()
        val awaited = NodesAwaited(fleet, patience) { log("$why$it") }
        awaited.check = ::requireOpen
        return awaited.await(1)
    }

    private fun begin(nodes: List<FleetNode>): Crew {
        val made = Crew(fleet.form(nodes), nodes, homeStep)
        crew = made
        // Another thread may have closed this meanwhile, and then has not seen the crew.
        if (isClosed) throw MailClosedException("the simulation is closed")
        val places = state.idPlaces
        val threads = IntArray(nodes.size) { nodes[it].threads }
        this.threads = threads.sum()
        val records = forcing.record != null
        val tally = forcing.tally?.kinds ?: -1
        val begin =
            Begin(scenario, homeStep, homeTime, homeCarried, records, tally, threads, places.ranked, places.count)
        made.begin(begin, state)
        return made
    }

    private fun dismiss() {
        crew?.close()
        crew = null
    }

    override fun close() {
        if (isClosed) return
        isClosed = true
        gate.close()
        handler.close()
        report.line()?.let(log)
        dismiss()
        fleet.close()
    }

    private fun count(nodes: Int) = if (nodes == 1) "1 node" else "$nodes nodes"

    private companion object {
        const val RENEWED = "the crew is renewed"
        const val PAUSE_MILLIS = 200L

        /** So many crews of the same nodes in a row may end before they have done what was asked. */
        const val MOST_IN_VAIN = 10
    }
}
