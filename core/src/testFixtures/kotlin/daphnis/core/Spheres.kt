package daphnis.core

import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population

/** One sphere of a hand-made case. */
class Sphere(
    val x: Double = 0.0,
    val y: Double = 0.0,
    val z: Double = 0.0,
    val vx: Double = 0.0,
    val vy: Double = 0.0,
    val vz: Double = 0.0,
    val r: Double = 1.0,
    val m: Double = 1.0,
)

fun populationOf(vararg s: Sphere): Population {
    fun column(value: (Sphere) -> Double) = DoubleArray(s.size) { value(s[it]) }
    return Population(
        column { it.x },
        column { it.y },
        column { it.z },
        column { it.vx },
        column { it.vy },
        column { it.vz },
        column { it.r },
        column { it.m },
    )
}

/** The same spheres in another order of the arrays, ids kept. */
fun Population.permuted(seed: Long): Population {
    val order = IntArray(size) { it }
    val random = SeededRandom(seed)
    for (k in size - 1 downTo 1) {
        val j = random.nextInt(k + 1)
        order[k] = order[j].also { order[j] = order[k] }
    }
    fun pick(a: DoubleArray) = DoubleArray(size) { a[order[it]] }
    val ids = IntArray(size) { id[order[it]] }
    return Population(pick(x), pick(y), pick(z), pick(vx), pick(vy), pick(vz), pick(radius), pick(mass), ids)
}
