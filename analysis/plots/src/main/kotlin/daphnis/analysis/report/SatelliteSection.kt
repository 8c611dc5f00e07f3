package daphnis.analysis.report

import daphnis.analysis.moonlet.BodyTable
import daphnis.analysis.moonlet.RandomWalk
import daphnis.analysis.statistics.BlockAverage
import daphnis.core.format.Snapshot
import daphnis.core.hill.Moon
import daphnis.core.run.BodyColumns
import kotlin.math.PI

/** Satellites that feel the ring: what it does to their orbits, and that it loses what they take up. */
internal class SatelliteSection(private val study: Study) : Section {
    private val units = study.units
    private val orbits = study.input.bodies.filter { it.id < 0 }.sortedByDescending { it.id }
    private val charts = OrbitCharts(study, orbits, "satellite")
    private val orbit = study.input.omega?.let { 2 * PI / it } ?: 1.0

    /** Σ m X of the ring in the first state and in the last, with X as if no face had been crossed. */
    private val ring = ArrayList<Double>()
    private val spheres = ArrayList<Int>()

    override val heading = "Satellites"
    override val over = "Those that feel the ring. Orbits: rows of bodies.csv from time ${study.time(study.from)} on."
    override val applies =
        study.isRing && study.input.scenario?.forces.orEmpty().any { it is Moon && it.carried != null }
    override val leftOut =
        if (orbits.isEmpty()) "where they went is not known: bodies.csv was not written (output.bodiesEvery)" else null
    override val followed = if (orbits.isEmpty()) emptyList() else listOf(0, study.input.size - 1).distinct()

    override fun follow(snapshot: Snapshot) {
        val frequencies = study.input.frequencies ?: return
        val width = if (study.last.boundary.repeats(0)) study.last.boundary.box.length(0) else 0.0
        var sum = 0.0
        for (k in 0 until snapshot.size) {
            val crossed = snapshot.image?.let { it[0][k] * width } ?: 0.0
            sum += snapshot.mass[k] * (frequencies.guidingX(snapshot.x[k], snapshot.vy[k]) + crossed)
        }
        ring += sum
        spheres += snapshot.size
    }

    override fun numbers(): List<NumberRow> {
        val first = orbits.firstOrNull() ?: return emptyList()
        val rows = NumberRows()
        val balance = balance()
        val name = "angular momentum that the ring lost over that which satellites took up"
        if (!balance.isNaN()) rows.exact(BALANCE, name, balance, "", "between the first state and the last")
        return of(first, "satellite") + rows.list()
    }

    /** Of one satellite; with a [key] to begin those of its numbers with. */
    private fun of(body: BodyTable, key: String?): List<NumberRow> {
        val late = body.from(study.from)
        val number = -body.id
        val rows = NumberRows()
        fun key(of: String) = key?.let { "${it}_$of" }
        val force = late.force(BodyColumns.GRAVITY_PUSH).filter { it.isFinite() }.toDoubleArray()
        if (force.isNotEmpty()) {
            val name = "mean force of the ring on satellite $number along its orbit"
            val unit = units.of("mass length/time^2")
            rows.average(key("force"), name, BlockAverage.of(force), unit, "times the distance from the planet: torque")
        }
        val e = late[BodyColumns.ECCENTRICITY]
        if (e.isNotEmpty()) {
            rows.average(key("eccentricity"), "a·e of satellite $number, mean", BlockAverage.of(e), units.length)
        }
        drift(late)?.let {
            val unit = "${units.length}/orbit"
            rows.change(key("drift"), "drift of a of satellite $number", it.drift * orbit, it.driftError * orbit, unit)
        }
        return rows.list()
    }

    /** Null for a time that is too short. */
    private fun drift(body: BodyTable): RandomWalk? {
        val time = body[BodyColumns.TIME]
        val isLong = time.size > 2 && time.last() - time[0] >= SHORTEST * orbit
        return if (isLong) RandomWalk.settled(listOf(time), listOf(body[BodyColumns.GUIDING_X]), orbit) else null
    }

    /** NaN where rows or spheres are missing, and where a satellite that keeps its orbit takes some. */
    private fun balance(): Double {
        val haveAll = orbits.size == MoonEncounter.moons(study.input.scenario).size
        if (ring.size < 2 || spheres[0] != spheres[1] || !haveAll) return Double.NaN
        val taken = orbits.sumOf { body ->
            val (first, last) = listOf(study.input.times.first(), study.input.times.last()).map { time ->
                body[BodyColumns.TIME].indexOfFirst { it == time }
            }
            if (first < 0 || last < 0) return Double.NaN
            val x = body[BodyColumns.GUIDING_X]
            body[BodyColumns.MASS][0] * (x[last] - x[first])
        }
        return (ring[0] - ring[1]) / taken
    }

    override fun write(page: ReportPage) {
        charts.write(page)
        val others = orbits.drop(1).flatMap { of(it, null) }
        if (others.isNotEmpty()) page.numbers(others)
    }

    private companion object {
        /** The fewest orbits over which a drift means something. */
        const val SHORTEST = 4.0
        const val BALANCE = "satellite_balance"
    }
}
