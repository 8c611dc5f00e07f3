package daphnis.core.cluster.bricks

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.cluster.bricks.Cuts.Companion.AXES
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.surface.ConstantRestitution

/** What a [BrickNet] does to messages. */
internal enum class NetTrouble {
    /** They arrive in any order, some twice, some of those steps later; nodes begin when they like. */
    ORDER_AND_COPIES,

    /** In the first attempt one bit of one sphere in sight of a brick is wrong in its halo. */
    FLIPPED_BIT,
}

/** Bricks that hear of one another by messages only, over a bad net, on one thread; halos start with no extra width. */
internal class BrickNet(
    start: Population,
    private val boundary: BoundaryConditions,
    private val dt: Double,
    private val division: BrickDivision,
    private val random: SeededRandom,
    private val trouble: NetTrouble,
) {
    private class Letter(val to: Int, val message: BrickMessage)

    private val first = start
    val population = start.copy()
    val counters = CollisionCounters()
    private val law = CollisionLaw(ConstantRestitution(0.9))
    private val step = CollisionStep(population, boundary, law, counters)
    private val whole = PreparedStep()
    private val margins = HaloMargins(0.0, 0.0)
    private val plan = ChosenTerritory(whole, margins, division)
    private val underway = ArrayList<Letter>()
    private val old = ArrayList<Letter>()
    private val agreed = HashMap<Int, Int>()

    private var territory = Territory(Cuts(List(AXES) { DoubleArray(0) }, boundary), boundary, epoch = 0)
    private lateinit var bricks: List<Brick>
    private lateinit var nodes: List<BrickNode>
    private lateinit var agreement: Agreement
    private var starts = IntArray(0)
    private var steps = 0L

    /** Messages that arrived when their attempt was over. */
    var late = 0
        private set
    var copies = 0
        private set
    var redone = 0
        private set

    /** Bricks that were right in one attempt and not in a later one of the same step. */
    var changedTheirMind = 0
        private set
    var flipped = 0
        private set

    fun simulation(engine: CollisionEngine): Simulation =
        Simulation(first.copy(), boundary, CollisionForcing(law.contactLaw, engine = engine), FixedTimeStep(dt))

    /** A step, with its boundary. */
    fun advance() {
        step.start = steps * dt
        step.duration = dt
        whole.measure(step)
        plan.prepare()
        if (territory !== plan.territory) settle(plan.territory)
        margins.diameter = 0.5
        val bound = whole.reach.bound.copyOf()
        val widths = HaloWidths(bound, DoubleArray(AXES), plan.bodies.edges(territory), margins.next())
        val key = AttemptKey(territory.epoch, steps++, 0)
        val input = StepInput(key, whole, population.size, widths, Halt())
        agreement.begin(key, widths)
        agreed.clear()
        val toBegin = nodes.indices.toMutableList()
        while (toBegin.isNotEmpty() || underway.isNotEmpty()) {
            if (toBegin.isNotEmpty() && (underway.isEmpty() || random.nextInt(8) == 0)) {
                val k = toBegin.removeAt(random.nextInt(toBegin.size))
                nodes[k].begin(input, Held(population, starts[k], starts[k + 1]))
            } else {
                deliver()
            }
        }
        check(agreement.isDone && nodes.all { it.isDone }) { "the step does not end" }
        redone += agreement.redone
        store()
        boundary.endStep(population, steps * dt)
    }

    private fun settle(territory: Territory) {
        this.territory = territory
        bricks = List(territory.size) { Brick() }
        nodes = List(territory.size) { k -> BrickNode(k, territory, bricks[k]) { to, message -> send(to, message) } }
        agreement = Agreement(territory.size, margins) { to, message -> send(to, message) }
        margins.reset(territory.size)
        starts = IntArray(territory.size + 1) { (population.size.toLong() * it / territory.size).toInt() }
        old.clear()
    }

    private fun send(to: Int, message: BrickMessage) {
        if (message is Agreed) {
            val before = agreed.put(message.from, if (message.isRight) 1 else 0)
            if (before == 1 && !message.isRight) changedTheirMind++
        }
        val letter = Letter(to, if (trouble == NetTrouble.FLIPPED_BIT) flip(to, message) else message)
        underway += letter
        if (trouble != NetTrouble.ORDER_AND_COPIES) return
        if (random.nextInt(3) == 0) {
            underway += letter
            copies++
        }
        if (random.nextInt(20) == 0) old += letter
    }

    private fun deliver() {
        if (old.isNotEmpty() && random.nextInt(20) == 0) {
            late++
            hand(old[random.nextInt(old.size)])
        }
        val k = if (trouble == NetTrouble.ORDER_AND_COPIES) random.nextInt(underway.size) else 0
        val letter = underway[k]
        underway[k] = underway.last()
        underway.removeLast()
        hand(letter)
    }

    private fun hand(letter: Letter) {
        val brick = letter.to
        if (brick == BrickMessage.AGREEMENT) agreement.receive(letter.message) else nodes[brick].receive(letter.message)
    }

    /** The first halo of the step with a sphere in sight gets a wrong bit in the last digits of one number. */
    private fun flip(to: Int, message: BrickMessage): BrickMessage {
        if (flipped > 0 || message !is Halo || message.key.attempt > 0 || random.nextInt(4) != 0) return message
        val near = (0 until message.near.runs).flatMap { message.near.from(it) until message.near.to(it) }
        val seen = near.filter { isTouchable(to, it) }
        if (seen.isEmpty()) return message
        val k = seen[random.nextInt(seen.size)]
        val spheres = population.copy()
        val column = listOf(spheres.x, spheres.y, spheres.z, spheres.vx, spheres.vy, spheres.vz, spheres.radius)
        val a = column[random.nextInt(column.size)]
        a[k] = Double.fromBits(a[k].toRawBits() xor (1L shl random.nextInt(20)))
        flipped++
        return Halo(message.key, message.from, spheres, message.own, message.near)
    }

    /** Whether sphere [k] is so near to the territory of [brick] that it is in sight for certain. */
    private fun isTouchable(brick: Int, k: Int): Boolean = (0 until AXES).all {
        territory.distance(it, territory.part(it, brick), population.position(it)[k]) <
            whole.reach.bound[it] + population.radius[k]
    }

    private fun store() {
        val columns = population.columnsToWrite(false)
        var at = 0
        for ((k, brick) in bricks.withIndex()) {
            starts[k] = at
            brick.store(columns, at)
            at += brick.spheres.own
            counters.add(brick.counted)
        }
        starts[bricks.size] = at
        population.take(columns)
    }
}
