package daphnis.core.engine

import daphnis.core.cluster.bricks.PathList
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows
import daphnis.core.engine.shares.PairList
import daphnis.core.force.Attractors
import daphnis.core.growth.IntList
import daphnis.core.population.Population
import daphnis.core.queue.EventHeap
import daphnis.core.queue.EventStore
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.TestFactory
import java.lang.reflect.Field
import java.lang.reflect.Modifier

/**
 * A step that runs out of memory while a table grows is undone, and may be done again. So a table of several arrays
 * must not think that it has room for what only some of them have room for. Here an array that is missing makes growing
 * fail where an allocation would.
 */
class FailedGrowthTest {
    /** A table; [add] appends entry k, [clear] forgets all, [content] says what it holds. */
    private class Table(val of: Any, val clear: () -> Unit, val content: () -> Any, val add: (k: Int) -> Unit) {
        val arrays: List<Field> = generateSequence<Class<*>>(of.javaClass) { it.superclass }
            .flatMap { it.declaredFields.asSequence() }
            .filter { it.type.isArray && !Modifier.isStatic(it.modifiers) }
            .onEach { it.isAccessible = true }
            .toList()

        private fun sizes() = arrays.map { java.lang.reflect.Array.getLength(it.get(of)) }

        /** How many entries it takes until arrays grow. */
        fun room(): Int {
            add(0)
            val first = sizes()
            var k = 1
            while (sizes() == first) add(k++)
            clear()
            return k - 1
        }
    }

    private val rows = StepRows().also { it.load(spheres(), IntArray(ENTRIES) { k -> k }, 1.0, false) }

    private fun spheres(): Population {
        fun column(of: (Int) -> Double) = DoubleArray(ENTRIES, of)
        val still = column { 0.0 }
        return Population(column { 2.0 * it }, still, still, still, still, still, column { 1.0 }, column { 1.0 })
    }

    private val tables = mapOf<String, () -> Table>(
        "collisions recorded" to {
            val record = CollisionRecord()
            fun entry(k: Int) = listOf(record.time[k], record.rank[k], record.lower[k], record.higher[k])
            Table(record, record::clear, { List(record.size) { entry(it) to record.impulse(it) } }) { k ->
                record.add(k.toDouble(), k, k + 1, CollisionOutcome())
            }
        },
        "events in a heap" to {
            val heap = EventHeap()
            val ids = IntArray(ENTRIES + 1) { it }
            heap.reset(1.0, ids, ids.size)
            Table(heap, { heap.reset(1.0, ids, ids.size) }, { generateSequence { heap.next() }.toList() }) { k ->
                heap.add(1.0 / (1 + k), k, -1, 0)
            }
        },
        "rows taken over" to {
            val taken = StepRows()
            Table(taken, taken::clear, { List(taken.size) { taken.id[it] to taken.state[it * StepRows.STRIDE] } }) {
                taken.take(rows, it)
            }
        },
        "hashes of paths" to {
            val list = PathList()
            Table(list, list::clear, { List(list.size) { list.id(it) to list.hash(it) } }) { list.add(it, 3L * it) }
        },
        "pairs" to {
            val list = PairList()
            Table(list, list::clear, { List(list.size) { list.first(it) to list.second(it) } }) { list.add(it, it, 0) }
        },
        "potential collisions" to {
            val store = EventStore(1)
            Table(store, store::clear, { List(store.size) { store.time(it) to store.first(it) } }) { k ->
                store.add(k.toDouble(), k, k + 1, 0)
            }
        },
        "attractors" to {
            val masses = Attractors()
            fun entry(k: Int) = listOf(masses.x[k], masses.y[k], masses.z[k], masses.mass[k])
            Table(masses, masses::clear, { List(masses.size, ::entry) }) { k ->
                masses.add(k.toDouble(), k + 0.25, k + 0.5, k + 0.75)
            }
        },
        "numbers" to {
            val list = IntList()
            Table(list, list::clear, { list.toArray().toList() }) { list.add(it) }
        },
    )

    private fun EventHeap.next() = if (pop()) time to first else null

    @TestFactory
    fun `a table that could not grow takes the same entries again`() = tables.map { (name, make) ->
        DynamicTest.dynamicTest(name) {
            val room = make().room()
            val refused = (room until room + 20).toList()
            // Another order than before, which begins with the entries that there was no room for.
            val again = refused + (ENTRIES - 1 downTo 0).filter { it !in refused }
            val whole = make().also { again.forEach(it.add) }.content()
            var failures = 0
            for (missing in make().arrays.indices) {
                val table = make()
                for (k in 0 until room) table.add(k)
                val field = table.arrays[missing]
                val array = field.get(table.of)
                field.set(table.of, null)
                failures += refused.count { runCatching { table.add(it) }.isFailure }
                if (field.get(table.of) == null) field.set(table.of, array)
                table.clear()
                again.forEach(table.add)
                assertEquals(whole, table.content()) { "after ${field.name} could not grow" }
            }
            assertTrue(failures > 0) { "nothing failed" }
        }
    }

    private companion object {
        const val ENTRIES = 3000
    }
}
