package consumer;

import daphnis.analysis.insitu.State;
import daphnis.analysis.order.RadialKey;
import daphnis.analysis.streamline.Streamlines;
import daphnis.core.Simulation;
import daphnis.core.engine.CollisionForcing;
import daphnis.core.population.Digest;
import daphnis.core.scenario.BuiltIn;
import daphnis.core.scenario.ScenarioSetup;
import java.util.Arrays;

/** Six steps of a ring and its streamlines; the last line is the state digest. */
class Ring {
    public static void main(String[] args) {
        var setup = ScenarioSetup.of(BuiltIn.scenario("ring-patch"), "ring-patch");
        var frequencies = setup.getFrequencies();
        var collisions = new CollisionForcing(setup.getRestitution(), setup.getGuard());
        var simulation = new Simulation(
            setup.getPopulation(), setup.getBoundary(), collisions, setup.getTimeStep(), setup.getForces());
        try (simulation) {
            for (int step = 0; step < 6; step++) simulation.advance();
            var lines = Streamlines.of(State.of(simulation, frequencies), 4, 5, RadialKey.GUIDING_CENTRE);
            int count = Arrays.stream(lines.getCount()).sum();
            System.out.println(count + " of " + simulation.getPopulation().getSize() + " spheres on streamlines");
            System.out.println(Digest.stateDigest(simulation.getPopulation()));
        }
    }
}
