package daphnis.core.engine

import daphnis.core.population.Population

/** Exchanges the entries [a] and [b] of [p] in all arrays. */
internal fun exchange(p: Population, a: Int, b: Int) {
    for (column in List(p.columnCount) { p.column(it) }) {
        if (column.isEmpty()) continue
        column[a] = column[b].also { column[b] = column[a] }
    }
    p.id[a] = p.id[b].also { p.id[b] = p.id[a] }
    p.orderChanged()
}
