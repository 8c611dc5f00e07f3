package daphnis.analysis

import daphnis.analysis.insitu.State
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.hill.Epicycle
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.populationOf
import java.nio.file.Files
import java.nio.file.Path
import kotlin.streams.asSequence

/**
 * [count] spheres of radius [radius] and mass 1, uniform in the box of [boundary] (overlapping: nothing collides here),
 * at rest unless [velocity] says otherwise.
 */
fun uniform(
    count: Int,
    boundary: BoundaryConditions,
    seed: Long = 1,
    radius: Double = 0.1,
    omega: Double? = null,
    velocity: (SeededRandom) -> Double = { 0.0 },
): State {
    val random = SeededRandom(seed)
    val box = boundary.box
    fun place(axis: Int) = DoubleArray(count) { random.nextDouble(box.lower(axis), box.upper(axis)) }
    val x = place(0)
    val y = place(1)
    val z = place(2)
    val v = Array(3) { DoubleArray(count) { velocity(random) } }
    boundary.meanFlow?.let { flow ->
        val across = listOf(x, y, z)[flow.normalAxis]
        for (k in 0 until count) v[flow.flowAxis][k] += flow.rate * across[k]
    }
    val radii = DoubleArray(count) { radius }
    return State(
        Population(
            x,
            y,
            z,
            v[0],
            v[1],
            v[2],
            radii,
            DoubleArray(count) {
                1.0
            },
        ),
        boundary,
        0.0,
        omega?.let { OrbitalFrequencies(it) },
    )
}

/** Particles on the epicycles given, in a frame of angular speed [omega]. */
fun onEpicycles(epicycles: List<Epicycle>, boundary: BoundaryConditions, omega: Double): State {
    val spheres = Array(epicycles.size) { k ->
        val s = epicycles[k].state(omega)
        Sphere(s[0], s[1], s[2], s[3], s[4], s[5], r = 0.1)
    }
    return State(populationOf(*spheres), boundary, 0.0, omega)
}

/**
 * Checks that [write] replaces the files of [directory] by others, in one act each: who has one of the old ones open, as
 * a second name stands for here, keeps it as it was.
 *
 * @param files how many there are at least
 */
fun requireReplacedWhole(directory: Path, files: Int, write: () -> Unit) {
    write()
    val written = Files.walk(directory).use { all -> all.asSequence().filter { Files.isRegularFile(it) }.toList() }
    check(written.size >= files) { "only $written" }
    val apart = Files.createTempDirectory(directory.toAbsolutePath().parent, "held")
    for ((k, file) in written.withIndex()) Files.createLink(apart.resolve("$k"), Files.writeString(file, "old"))
    write()
    for ((k, file) in written.withIndex()) {
        check(holdsOld(apart.resolve("$k"))) { "$file was written in place" }
        check(!holdsOld(file)) { "$file was not written" }
    }
    val now = Files.walk(directory).use { all -> all.asSequence().filter { Files.isRegularFile(it) }.toSet() }
    check(now == written.toSet()) { "left behind: ${now - written.toSet()}" }
}

private fun holdsOld(file: Path) = Files.readAllBytes(file).contentEquals("old".toByteArray())
