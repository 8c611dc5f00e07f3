package consumer;

import daphnis.analysis.insitu.State;
import daphnis.analysis.order.RadialKey;
import daphnis.analysis.streamline.Streamlines;
import daphnis.core.Simulation;
import daphnis.core.engine.CollisionForcing;
import daphnis.core.population.Digest;
import daphnis.core.run.Run;
import daphnis.core.scenario.BuiltIn;
import daphnis.core.scenario.ScenarioSetup;
import java.io.IOException;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.Comparator;

/** Six steps of a ring and its streamlines, then the same in a directory; the last line is the state digest. */
class Ring {
    public static void main(String[] args) throws IOException {
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
        }
        var home = Files.createTempDirectory("consumer");
        try (var run = Run.builder(BuiltIn.scenario("ring-patch")).directory(home.resolve("run")).steps(6).start()) {
            run.execute();
        }
        for (var state : Run.open(home.resolve("run")).states()) {
            if (state.getStep() == 6) System.out.println(Digest.stateDigest(state.population()));
        }
        try (var files = Files.walk(home)) {
            files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
        }
    }
}
