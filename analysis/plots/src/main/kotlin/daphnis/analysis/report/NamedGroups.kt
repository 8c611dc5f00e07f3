package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.MaterialGroups
import daphnis.analysis.insitu.SizeGroups
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import java.math.BigDecimal
import kotlin.math.abs

/**
 * The two or three kinds of particles of a mixture: materials, or radii where there is one material.
 *
 * @property kind what tells them apart, at the end of the names of tables
 * @property names of the groups; null for those that have no particle
 */
internal class NamedGroups private constructor(val groups: SphereGroups, val kind: String, val names: List<String?>) {
    private val there = names.indices.filter { names[it] != null }

    /** Pairs of kinds that have particles, each once. */
    val pairs: List<Pair<Int, Int>> = there.flatMap { a -> there.filter { it >= a }.map { a to it } }

    fun name(pair: Pair<Int, Int>): String = "${names[pair.first]}-${names[pair.second]}"

    /**
     * Draws numbers of [averages] over [x] for each pair of groups, from entry [first] (a, b) on, and writes them as a
     * table.
     *
     * @param argument what x is, and its unit
     * @param short its name in the table
     */
    fun write(
        study: Study,
        page: ReportPage,
        name: String,
        x: DoubleArray,
        averages: Averages,
        symbol: String,
        argument: Pair<String, String>,
        short: String,
        caption: String,
        first: (Int, Int) -> Int,
    ) {
        val curves = ArrayList<Curve>()
        val columns = arrayListOf(Column(short, argument.second, x))
        for (pair in pairs) {
            val all = List(x.size) { averages.average(first(pair.first, pair.second) + it) }
            if (all.all { it.mean.isNaN() }) continue
            val mean = DoubleArray(all.size) { all[it].mean }
            val error = DoubleArray(all.size) { study.judgement.error(all[it]) }
            curves += Curve(name(pair), x, mean)
            columns +=
                listOf(Column("${symbol}_${name(pair)}", "", mean), Column("${symbol}_${name(pair)}_error", "", error))
        }
        if (curves.isEmpty()) return
        Table("$name-by-$kind", columns).write(study.tables)
        val figure = Chart.lines(
            curves,
            UnitNames.axis(argument.first, argument.second),
            "${name.replace('-', ' ')} $symbol",
        )
        study.draw(page, figure, "$name-by-$kind", "${name.replace('-', ' ')} by $kind", caption)
    }

    companion object {
        /** Kinds up to which each pair has a curve. */
        private const val MOST = 3
        private const val SAME = 1e-9
        private const val DIGITS = 4

        /** The groups of [named], or all particles. */
        fun of(named: NamedGroups?): SphereGroups = named?.groups ?: SphereGroups.ALL

        /** Those of the last state of [study]; null for one kind, or for many. */
        fun of(study: Study): NamedGroups? = byMaterial(study) ?: bySize(study)

        private fun byMaterial(study: Study): NamedGroups? {
            val last = study.last
            val groups = MaterialGroups.of(last) ?: return null
            val there = (0 until last.population.size).filter {
                last.isParticle(it)
            }.map { groups.of(last, it) }.toSet()
            if (there.size !in 2..MOST) return null
            val names = last.population.materials.mapIndexed { k, name -> name.takeIf { k in there } }
            return NamedGroups(groups, "material", names)
        }

        private fun bySize(study: Study): NamedGroups? {
            val last = study.last
            val groups = SizeGroups.of(last, MOST) ?: return null
            val radii = List(groups.count) { g ->
                (0 until last.population.size)
                    .filter { last.isParticle(it) && groups.of(last, it) == g }
                    .map { last.population.radius[it] }
            }
            if (radii.any { r -> r.isEmpty() || r.any { abs(it / r[0] - 1) > SAME } }) return null
            return NamedGroups(
                groups,
                "size",
                radii.map {
                    BigDecimal(ReportText.plain(it[0], DIGITS)).stripTrailingZeros().toPlainString()
                },
            )
        }
    }
}
