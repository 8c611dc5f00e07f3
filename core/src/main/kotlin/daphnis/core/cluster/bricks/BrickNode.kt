package daphnis.core.cluster.bricks

/**
 * The part of one brick in a step, as a state machine without threads: [begin] starts a step, [receive] takes a
 * message, and both post what follows. Messages may arrive in any order and more than once; one that is early waits,
 * one that is late or known is dropped.
 *
 * ```
 *             begin: Halo to all             Halo from all: compute, Outcome to all
 *   IDLE ────────────────────────▶ GATHERING ──────────────────────────────▶ COMPARING
 *     ▲                                ▲                                     │  Outcome from all:
 *     │ Go                             │ Redo, this brick computes again     ▼  compare, Agreed
 *     └────────────────────────────────┴──────────────────────────────── ANSWERED
 *                                        Redo, this brick does not: Outcome to all, COMPARING
 * ```
 *
 * The node holds any spheres at the start, wherever they are: the first messages bring each to its owner and to the
 * halos that it is in. So there is no round of messages for those that have crossed a border.
 */
internal class BrickNode(
    private val number: Int,
    private val territory: Territory,
    private val brick: Brick,
    private val post: Post,
) {
    private enum class State { IDLE, GATHERING, COMPARING, ANSWERED }

    private var state = State.IDLE
    private var key = NEVER
    private lateinit var input: StepInput
    private lateinit var held: Held
    private lateinit var widths: HaloWidths

    /** The widths with which the halo was gathered; [widths] may be larger after an attempt without this brick. */
    private lateinit var gathered: HaloWidths

    private val bricks = territory.size
    private val vicinity = Vicinity(territory, number)
    private val middle = territory.middle(number)
    private val own = Array(bricks) { IndexRuns() }
    private val near = Array(bricks) { IndexRuns() }
    private val paths = Array(bricks) { PathList() }
    private val halos = arrayOfNulls<Halo>(bricks)
    private val outcomes = arrayOfNulls<Outcome>(bricks)
    private var halosMissing = 0
    private var outcomesMissing = 0
    private val early = ArrayList<BrickMessage>()
    private val check = PathComparison(number, territory, brick)

    /** Whether it takes whatever it has computed for right; for tests of what happens then. */
    var isTrusting = false

    /** What ended the computation of the present attempt; null when nothing did. */
    var failure: Exception? = null
        private set

    /** Whether the step that was begun is agreed on. */
    val isDone: Boolean get() = state == State.IDLE

    /** Begins the step of [input] with the spheres [held]. */
    fun begin(input: StepInput, held: Held) {
        this.input = input
        this.held = held
        widths = input.widths
        open(input.key, computes = BooleanArray(bricks) { true })
    }

    /** Begins an attempt in which the bricks that [computes] says compute anew. */
    private fun open(key: AttemptKey, computes: BooleanArray) {
        this.key = key
        outcomes.fill(null)
        outcomesMissing = bricks - 1
        halos.fill(null)
        halosMissing = bricks - 1
        sort()
        for (to in 0 until bricks) {
            if (to != number && computes[to]) post.send(to, Halo(key, number, held.spheres, own[to], near[to]))
        }
        if (computes[number]) {
            state = State.GATHERING
            computeIfComplete()
        } else {
            sendOutcomes()
        }
        val waiting = early.toTypedArray()
        early.clear()
        for (message in waiting) receive(message)
    }

    /** Finds who needs which of the spheres held. */
    private fun sort() {
        vicinity.prepare(widths)
        for (k in 0 until bricks) {
            own[k].clear()
            near[k].clear()
        }
        if (bricks == 1) {
            own[number].addAll(held.from, held.to)
            return
        }
        val x = held.spheres.x
        val y = held.spheres.y
        val z = held.spheres.z
        val radius = held.spheres.radius
        for (k in held.from until held.to) {
            vicinity.look(x[k], y[k], z[k], radius[k])
            own[vicinity.owner].add(k)
            for (n in 0 until vicinity.size) near[vicinity.others[n]].add(k)
        }
    }

    /** Takes [message]. */
    fun receive(message: BrickMessage) {
        if (message is Redo && state == State.ANSWERED && message.key == key.next) {
            widths = message.widths
            open(message.key, message.again)
        } else if (message.key > key) {
            early.add(message)
        } else if (message.key == key) {
            receivePresent(message)
        }
    }

    private fun receivePresent(message: BrickMessage) {
        when (message) {
            is Halo -> if (state == State.GATHERING && halos[message.from] == null) {
                halos[message.from] = message
                halosMissing--
                computeIfComplete()
            }
            is Outcome -> if (state != State.IDLE && outcomes[message.from] == null) {
                outcomes[message.from] = message
                outcomesMissing--
                compareIfComplete()
            }
            is Go -> if (state == State.ANSWERED) state = State.IDLE
            is Redo, is Agreed -> Unit
        }
    }

    private fun computeIfComplete() {
        if (halosMissing > 0) return
        gathered = widths
        failure = null
        try {
            brick.solve(input.whole, middle, input.halt, isAgain = key.attempt > 0, gathering)
            check.index()
        } catch (e: Exception) {
            failure = e
        }
        sendOutcomes()
    }

    private val gathering = object : Gathering {
        override val count: Int
            get() {
                var count = own[number].size + near[number].size
                for (halo in halos) if (halo != null) count += halo.own.size + halo.near.size
                return count
            }

        override fun into(spheres: BrickSpheres) {
            spheres.add(held.spheres, own[number], areOwn = true)
            for (halo in halos) if (halo != null) spheres.add(halo.spheres, halo.own, areOwn = true)
            spheres.add(held.spheres, near[number], areOwn = false)
            for (halo in halos) if (halo != null) spheres.add(halo.spheres, halo.near, areOwn = false)
        }
    }

    /** Tells all what became of those own spheres that are in their halos. */
    private fun sendOutcomes() {
        state = State.COMPARING
        for (list in paths) list.clear()
        val spheres = brick.spheres
        // After a failure others miss what is in their sight.
        if (failure == null && bricks > 1) {
            val x = spheres.x
            val y = spheres.y
            val z = spheres.z
            val radius = spheres.radius
            spheres.forEachOwn { k ->
                vicinity.look(x[k], y[k], z[k], radius[k])
                if (vicinity.size > 0) {
                    val hash = brick.wholePath(k)
                    for (n in 0 until vicinity.size) paths[vicinity.others[n]].add(spheres.id[k], hash)
                }
            }
        }
        for (to in 0 until bricks) {
            if (to != number) post.send(to, Outcome(key, number, paths[to], brick.bound))
        }
        compareIfComplete()
    }

    private fun compareIfComplete() {
        if (state != State.COMPARING || outcomesMissing > 0) return
        state = State.ANSWERED
        val isRight = isTrusting || failure == null && check.isRight(gathered, outcomes, input.total)
        val counts = BrickCounts(brick.spheres.own.toLong(), brick.counted.collisions, brick.counted.wallCollisions)
        post.send(BrickMessage.AGREEMENT, Agreed(key, number, isRight, brick.bound, counts, failure != null))
    }

    private companion object {
        val NEVER = AttemptKey(0, -1, 0)
    }
}
