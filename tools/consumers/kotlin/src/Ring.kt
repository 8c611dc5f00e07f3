import daphnis.analysis.insitu.State
import daphnis.analysis.order.RadialKey
import daphnis.analysis.streamline.Streamlines
import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.stateDigest
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup

/** Six steps of a ring and its streamlines; the last line is the state digest. */
fun main() {
    val setup = ScenarioSetup.of(BuiltIn.scenario("ring-patch"), "ring-patch")
    val frequencies = checkNotNull(setup.frequencies)
    val collisions = CollisionForcing(setup.restitution, setup.guard)
    Simulation(setup.population, setup.boundary, collisions, setup.timeStep, setup.forces).use {
        repeat(6) { _ -> it.advance() }
        val lines = Streamlines.of(State.of(it, frequencies), slabs = 4, groups = 5, RadialKey.GUIDING_CENTRE)
        println("${lines.count.sum()} of ${it.population.size} spheres on streamlines")
        println(stateDigest(it.population))
    }
}
