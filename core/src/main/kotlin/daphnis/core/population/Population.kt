package daphnis.core.population

import daphnis.core.population.SphereQuantity.LAST_COLLISION
import java.util.function.IntPredicate
import java.util.stream.IntStream

/**
 * Spheres as a structure of arrays: entry `k` of every array belongs to the sphere with the stable id `id[k]`.
 *
 * The **index** `k` of a sphere changes from step to step, because engines keep neighbours in space next to one another
 * in memory. Its **id** never changes. Address a sphere across steps by id, see [indexOf]. The arrays are shared, not
 * copied: an analysis may read them between two calls of `advance()`, and a force may write the velocities. **Read them
 * anew after each `advance()`**: a step is written to a second set of arrays, which then becomes the population's. The
 * previous set is kept, so that the step can be taken back if it fails. Radii, masses and ids, which no step changes,
 * may stay in the same arrays: change them, or the order, between steps only. Not thread-safe; during `advance()` the
 * population belongs to the engine.
 */
public class Population internal constructor(
    columns: PopulationColumns,
    /**
     * Names of the materials that spheres are made of, by number, see [SphereColumns.material]; empty where none have
     * been named. Not a part of what the digest takes in.
     */
    public val materials: List<String>,
) : SphereColumns {
    internal val sets = ColumnSets(columns)
    private val now: PopulationColumns get() = sets.now

    override val id: IntArray get() = now.id

    override fun column(place: Int): DoubleArray = now.column(place)

    override val bonds: Array<IntArray> get() = now.bonds

    /**
     * Time since each sphere's last collision, as a negative number counted from the end of the last step, or −∞ when
     * it never collided. Kept only while a collapse guard asks for it; part of the state of a run, though not of the
     * digest.
     */
    override val lastCollision: DoubleArray get() = now.column(LAST_COLLISION.place)

    /** Number of spheres. */
    override val size: Int get() = x.size

    /** See [boxesCrossed]; of a part since [beginPart], those of spheres that are elsewhere now with them. */
    internal var crossings: Crossings
        private set

    /** Where ids have their places. */
    internal val idPlaces: IdPlaces get() = crossings.places

    /** The crossings at the start of the step under way, if spheres were added in it; otherwise the same object. */
    private var crossingsBefore: Crossings
    private var indexByPlace = IntArray(0)
    private var indexIsCurrent = false

    /** Of a part of another population, see [beginPart]; else null. */
    internal var news: PartNews? = null
        private set

    /**
     * @param x positions, in the scenario's unit of length; likewise [y], [z]
     * @param vx velocities, unit of length per unit of time; likewise [vy], [vz]
     * @param radius radii, > 0
     * @param mass masses, > 0
     * @param id distinct, in 0..[Int.MAX_VALUE], possibly with gaps; 0, 1, 2, … when not given
     * @throws IllegalArgumentException when the lengths differ, a number is not finite, a radius or mass is not
     *   positive, or an id occurs twice
     */
    @JvmOverloads
    public constructor(
        x: DoubleArray,
        y: DoubleArray,
        z: DoubleArray,
        vx: DoubleArray,
        vy: DoubleArray,
        vz: DoubleArray,
        radius: DoubleArray,
        mass: DoubleArray,
        id: IntArray = IntArray(x.size) { it },
    ) : this(PopulationColumns.of(arrayOf(x, y, z, vx, vy, vz, radius, mass), id), emptyList())

    init {
        PopulationCheck.columns(now)
        MaterialNames.check(this, materials)
        crossings = Crossings(IdPlaces(PopulationCheck.sortedIds(id)))
        crossingsBefore = crossings
    }

    /** The present index of the sphere with the stable id [id], −1 when there is none. Allocates nothing once warm. */
    public fun indexOf(id: Int): Int {
        val place = idPlaces.of(id)
        return if (place in 0 until idPlaces.count) indexAt(place) else -1
    }

    /** The indices of all spheres in the order of their ids. Allocates. */
    public fun indicesById(): IntArray = IntStream.range(0, places).map { indexAt(it) }.filter { it >= 0 }.toArray()

    /**
     * Number of places for ids, about as many as spheres: for loops in the order of ids that allocate nothing, see
     * [indexAt].
     */
    internal val places: Int get() = idPlaces.count

    /** The present index of the sphere at [place] in the order of ids, in 0 until [places]; −1 when there is none. */
    internal fun indexAt(place: Int): Int {
        if (!indexIsCurrent) indexIds()
        return indexByPlace[place]
    }

    /** To be called after the arrays were permuted. */
    public fun orderChanged() {
        indexIsCurrent = false
    }

    /**
     * Through how many boxes the sphere with the stable id [id] has gone along [axis] (0 = x, 1 = y, 2 = z), counted
     * positive upward. Its position is the one that it would have without images, minus this many lengths of the box.
     * Where images slide, the count along the slide refers to images that were aligned at time 0 and have slid since by
     * velocity · time, not reduced to the box.
     */
    public fun boxesCrossed(id: Int, axis: Int): Int = crossings.of(id, axis)

    /**
     * Adds to [boxesCrossed] of the sphere at [index], for boundaries that put it that many boxes back. Threads may
     * call this at the same time for different spheres. Part of the state of a run, though not of the digest. It costs
     * nothing for spheres that do not cross.
     */
    public fun addCrossing(index: Int, axis: Int, boxes: Int): Unit = crossings.add(id[index], axis, boxes)

    /** Keeps the spheres whose index [keep] accepts, with their ids, for boundaries that remove the rest. Allocates. */
    public fun retain(keep: IntPredicate) {
        val kept = IntArray(size)
        var n = 0
        for (k in 0 until size) if (keep.test(k)) kept[n++] = k
        if (n == size) return
        val left = PopulationColumns.picked(now, kept.copyOf(n))
        news?.let { for (k in 0 until size) if (!keep.test(k)) it.remove(id[k]) }
        sets.replace(left)
        indexIsCurrent = false
        // Partners of a part may be elsewhere, see [forget].
        if (news == null) for (k in left.bonds.indices) left.bonds[k] = Bonds.only(left.bonds[k]) { indexOf(it) >= 0 }
    }

    /** The spheres [gone], some of which were elsewhere, are nobody's partners any more; after the drift of a step. */
    internal fun forget(gone: IntArray): Unit = Bonds.forget(bonds, gone)

    /**
     * Adds the spheres of [others], with their ids, times of collision and boxes crossed, after those that are there;
     * [others] does not change. It costs a copy of all arrays, so add many spheres at once. Within a step only the
     * boundary may call it, and it is taken back with the step. Allocates.
     *
     * @throws IllegalArgumentException when a sphere that is there has one of the ids, only [others] have spins or
     *   materials, or their materials have other names; then nothing is changed. When only those that are there have
     *   them, those of [others] are 0
     */
    public fun add(others: Population) {
        if (others.size == 0) return
        for (id in others.id) require(indexOf(id) < 0) { "id $id is taken; a sphere that is added needs a new one" }
        PopulationCheck.mayJoin(this, others)
        val all = PopulationColumns.joined(listOf(now, others.now))
        val counts = crossings.only(all.id, id.asList())
        others.crossings.copyInto(counts, others.id.asList())
        sets.replace(all)
        count(counts)
    }

    /** Adds [others]; [ids] are all that are added on any node, ascending, above those that are there but maybe not gone. */
    internal fun join(others: PopulationColumns, ids: IntArray) {
        val before = id
        if (others.size > 0) sets.replace(PopulationColumns.joined(listOf(now, others)))
        count(if (news != null) crossings.alsoFor(ids) else crossings.only(id, before.asList()))
        news?.bear(ids[0])
    }

    /** The spheres that will be taken are [ids], and of them those from [born] on are new. */
    internal fun expect(ids: IntArray, born: Int) {
        val there = id.filter { it < born }
        if (born != PartNews.NONE) count(crossings.only((ids.asList() + there).distinct().toIntArray(), there))
    }

    /** From now on crossings are counted by [counts], which has its places. */
    private fun count(counts: Crossings) {
        if (sets.isInStep) counts.begin()
        crossings = counts
        indexIsCurrent = false
    }

    /**
     * Makes room for the spheres of [places] all of which may come from other nodes, and counts crossings from 0. For a
     * population that is a part of another.
     *
     * @param areFew see [Crossings]
     */
    internal fun beginPart(places: IdPlaces, areFew: Boolean = true) {
        news = PartNews()
        crossings = Crossings(places, areFew)
        crossingsBefore = crossings
        indexIsCurrent = false
    }

    /** A deep copy with these angular velocities by index, see [SphereColumns.wx]; of the length of the others, finite. */
    public fun withSpin(wx: DoubleArray, wy: DoubleArray, wz: DoubleArray): Population {
        val spins = listOf(wx.copyOf(), wy.copyOf(), wz.copyOf())
        return copyOf(PopulationColumns.joined(listOf(this)).with(SphereQuantity.SPIN, spins), materials)
    }

    /**
     * A deep copy of spheres that are made of the materials [names], of which [material] has the number of each sphere
     * by index: 0 for the first name.
     *
     * @param names words of letters, digits, `_` and `-`, distinct
     * @throws IllegalArgumentException when a name is not such a word or occurs twice, a number is that of no name, or
     *   there are not as many numbers as spheres
     */
    public fun withMaterial(material: IntArray, names: List<String>): Population {
        require(names.isNotEmpty()) { "no material is named; give a name for each number" }
        val numbers = listOf(DoubleArray(material.size) { material[it].toDouble() })
        return copyOf(PopulationColumns.joined(listOf(this)).with(SphereQuantity.MATERIAL, numbers), names.toList())
    }

    /** A deep copy. */
    public fun copy(): Population = copyOf(PopulationColumns.joined(listOf(this)), materials)

    private fun copyOf(columns: PopulationColumns, names: List<String>) =
        Population(columns, names).also { copy -> crossings.copyInto(copy.crossings, id.asList()) }

    /**
     * Columns to which a whole step is written, and which [take] makes those of the population. Until then the
     * population is as it was, whatever happens. Columns of a failed step are dropped, since a late thread may still
     * write to them.
     *
     * @param tracksLastCollision whether the step writes [lastCollision]
     * @param count number of spheres after the step; other than [size] where spheres come from and go to other nodes
     * @param keepsOrder whether index k stays that of the same sphere; then the columns have the population's
     *   [radius], [mass] and [id], which are not to be written
     */
    internal fun columnsToWrite(
        tracksLastCollision: Boolean,
        count: Int = size,
        keepsOrder: Boolean = false,
    ): PopulationColumns = sets.toWrite(count, keepsOrder, tracksLastCollision)

    /** From now on pairs have these states, see [bonds]. */
    internal fun bind(bonds: Array<IntArray>): Unit = sets.bind(bonds)

    /** To be called with [columnsToWrite] that are not written to any more and not taken. */
    internal fun giveBack(columns: PopulationColumns): Unit = sets.giveBack(columns)

    /** Makes [columns] the columns of the population. Cannot fail. */
    internal fun take(columns: PopulationColumns) {
        sets.take(columns)
        indexIsCurrent = false
    }

    /** Moves every sphere along its straight path, for a step without collisions. */
    internal fun drift(duration: Double) {
        val to = columnsToWrite(tracksLastCollision = false, keepsOrder = true)
        now.driftInto(to, duration)
        take(to)
    }

    /** Begins a step that can be taken back until [commitStep]. */
    internal fun beginStep() {
        news?.takeRemoved()
        sets.begin()
        crossingsBefore = crossings
        crossings.begin()
    }

    /** Keeps the step. Cannot fail. */
    internal fun commitStep() {
        sets.commit()
        crossingsBefore = crossings
        crossings.commit()
    }

    /** Restores everything as it was at [beginStep], but for what was written to arrays of that moment. Cannot fail. */
    internal fun takeStepBack() {
        if (!sets.takeBack()) return
        news?.takeRemoved()
        indexIsCurrent = false
        crossings = crossingsBefore
        crossings.takeBack()
    }

    private fun indexIds() {
        if (indexByPlace.size != places) indexByPlace = IntArray(places)
        indexByPlace.fill(-1)
        for (k in 0 until size) indexByPlace[idPlaces.of(id[k])] = k
        indexIsCurrent = true
    }

    public companion object {
        /** Names the columns of a population one by one. */
        @JvmStatic
        public fun builder(): PopulationBuilder = PopulationBuilder()
    }
}
