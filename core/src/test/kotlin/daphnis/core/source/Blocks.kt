package daphnis.core.source

import daphnis.core.population.Population
import kotlin.math.sqrt

/** A mean with its standard error. */
class Mean(val value: Double, val error: Double) {
    override fun toString(): String = "$value ± $error"
}

/** The mean of [numbers] in order of time, with the error from the scatter of [count] blocks of them. */
fun blocks(numbers: List<Double>, count: Int = 20): Mean {
    val means = numbers.chunked(numbers.size / count).take(count).map { it.average() }
    val mean = means.average()
    return Mean(mean, sqrt(means.sumOf { (it - mean) * (it - mean) } / (count - 1) / count))
}

/** No spheres at all. */
internal fun empty() = DoubleArray(0).let { Population(it, it, it, it, it, it, it, it) }
