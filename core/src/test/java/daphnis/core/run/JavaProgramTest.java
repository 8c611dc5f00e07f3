package daphnis.core.run;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import daphnis.core.Engines;
import daphnis.core.FixedTimeStep;
import daphnis.core.Opening;
import daphnis.core.Output;
import daphnis.core.OutputState;
import daphnis.core.Simulation;
import daphnis.core.boundary.Box;
import daphnis.core.boundary.Periodic;
import daphnis.core.collision.ConstantRestitution;
import daphnis.core.engine.CollisionForcing;
import daphnis.core.force.Kick;
import daphnis.core.format.Snapshot;
import daphnis.core.hill.Epicycle;
import daphnis.core.parallel.InlineLoop;
import daphnis.core.population.Conserved;
import daphnis.core.population.GranularTemperatureKt;
import daphnis.core.population.Population;
import daphnis.core.population.PopulationSums;
import daphnis.core.scenario.BuiltIn;
import daphnis.core.scenario.OutputSpec;
import daphnis.core.search.NearPairs;
import daphnis.core.search.Overlap;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A program in Java with a law, a force and an output of its own in a run directory. */
class JavaProgramTest {
    @TempDir Path home;

    // example: javaProgram
    /** Spheres on springs, in a periodic box. */
    static class Springs implements Program {
        final Energies energies = new Energies();

        @Override public String getName() { return "springs"; }

        @Override public String getVersion() { return "1"; }

        @Override public double getUntil() { return 4.0; }

        @Override public OutputSpec getOutput() { return new OutputSpec(1, 10, 10); }

        @Override public Map<String, Output> outputs() { return Map.of("energies", energies); }

        @Override public Population population() {
            double[] x = {-3.0, 0.0, 3.0};
            double[] vx = {1.0, 0.0, -0.5};
            double[] zero = new double[3];
            double[] one = {1.0, 1.0, 1.0};
            return new Population(x, zero, zero.clone(), vx, zero.clone(), zero.clone(), one.clone(), one);
        }

        @Override public Simulation simulation(Population population) {
            Kick spring = (p, time, duration) -> {
                for (int k = 0; k < p.getSize(); k++) p.getVx()[k] -= 0.1 * duration * p.getX()[k];
            };
            var boundary = new Periodic(Box.centred(10.0, 10.0, 10.0));
            var collisions = new CollisionForcing(new ConstantRestitution(0.8));
            return new Simulation(population, boundary, collisions, new FixedTimeStep(0.1), List.of(spring));
        }
    }

    /** The kinetic energy after every step, kept over a resume. */
    static class Energies implements Output {
        final List<Double> all = new ArrayList<>();

        @Override public void write(Simulation simulation) {
            all.add(Conserved.of(simulation.getPopulation()).getKineticEnergy());
        }

        @Override public void save(OutputState state) {
            state.put("all", array());
        }

        @Override public void restore(OutputState state) {
            for (double energy : state.doubles("all")) all.add(energy);
        }

        double[] array() {
            return all.stream().mapToDouble(Double::doubleValue).toArray();
        }
    }
    // end

    private final Springs whole = new Springs();

    @Test
    void statesOfARunAreReadOneByOne() {
        wholeDigest();
        Path directory = home.resolve("whole");
        // example: recordedInJava
        double last = Double.NaN;
        for (Snapshot state : Run.open(directory).states()) last = state.getTime();
        // end
        assertEquals(4.0, last, 1e-12);
        assertEquals(10, Run.open(directory).atStep(10).getStep());
        assertEquals(20, Run.open(directory).at(2.0).getStep());
    }

    private String wholeDigest() {
        try (Run run = Run.start(whole, home.resolve("whole"))) {
            Summary summary = run.execute();
            assertTrue(summary.getFinished() && summary.getCollisions() > 0);
            return summary.getStateDigest();
        }
    }

    @Test
    void closedMidwayAndResumedItEndsAsInOneGo() {
        String digest = wholeDigest();
        Path path = home.resolve("closed");
        try (Run run = Run.start(new Springs(), path)) {
            assertFalse(run.execute(simulation -> {}, () -> run.getSimulation().getStep() >= 17).getFinished());
        }
        Springs resumed = new Springs();
        try (Run run = Run.resume(resumed, path)) {
            assertEquals(17, run.getResumedFrom());
            assertEquals(List.of(), run.getNotices());
            assertEquals(digest, run.execute().getStateDigest());
        }
        assertArrayEquals(whole.energies.array(), resumed.energies.array());
        assertEquals(41, resumed.energies.all.size());
        assertEquals(digest, Summary.read(path.resolve("summary.json")).getStateDigest());
    }

    /** Throws in one phase; what is checked, Java only lets through unseen. */
    static class Failing implements Output {
        final String phase;
        final Exception thrown;

        Failing(String phase, Exception thrown) {
            this.phase = phase;
            this.thrown = thrown;
        }

        @SuppressWarnings("unchecked")
        <E extends Exception> void call(String now) throws E {
            if (now.equals(phase)) throw (E) thrown;
        }

        @Override public void open(Simulation simulation, Opening opening) { this.<RuntimeException>call("open"); }

        @Override public void write(Simulation simulation) { this.<RuntimeException>call("write"); }

        @Override public void save(OutputState state) {
            state.put("one", new double[] {1.0});
            this.<RuntimeException>call("save");
        }

        @Override public void restore(OutputState state) { this.<RuntimeException>call("restore"); }

        @Override public void finish(Simulation simulation) { this.<RuntimeException>call("finish"); }

        @Override public void close() { this.<RuntimeException>call("close"); }
    }

    private static void runWith(Failing failing, Path path) {
        boolean isStart = !failing.phase.equals("restore");
        Map<String, Output> first = Map.of("java", isStart ? failing : new Failing("", null));
        var scenario = BuiltIn.scenario("cooling-gas", List.of("particles.count=20", "until=0.1"));
        try (Run run = Run.start(scenario, "gas", path, true, Engines.INSTANCE, first)) {
            run.execute();
        }
        if (!isStart) Run.resume(path, null, Engines.INSTANCE, false, Map.of("java", failing)).close();
    }

    @Test
    void whatAnOutputThrowsInAnyPhaseEndsTheRunByName() {
        for (String phase : List.of("open", "write", "save", "finish", "close", "restore")) {
            Path path = home.resolve(phase);
            for (var thrown : List.of(new TimeoutException("late"), new IllegalStateException("late"))) {
                var e = assertThrows(RunException.class, () -> runWith(new Failing(phase, thrown), path), phase);
                assertTrue(e.getMessage().matches("step \\d+: output 'java'.*: late"), e.getMessage());
                assertSame(thrown, e.getCause());
            }
            var full = new IOException("no room");
            for (var thrown : List.of(full, new UncheckedIOException(full))) {
                var e = assertThrows(RunException.class, () -> runWith(new Failing(phase, thrown), path), phase);
                assertTrue(e.getMessage().startsWith("cannot write to " + path + ": no room"), e.getMessage());
                assertSame(full, e.getCause());
            }
        }
    }

    @Test
    void killedBetweenCheckpointsItGoesOnFromTheLast() {
        String digest = wholeDigest();
        Path path = home.resolve("killed");
        List<String> calls = new ArrayList<>();
        try (Run run = Run.start(new Springs(), path)) {
            Output killer = new Output() {
                @Override public void open(Simulation simulation, Opening opening) { calls.add(opening.name()); }

                @Override public void write(Simulation simulation) {
                    if (simulation.getStep() == 25) throw new IllegalStateException("killed");
                }

                @Override public void close() { calls.add("closed"); }
            };
            RunException e = assertThrows(RunException.class, () -> run.execute(killer));
            assertEquals("step 25: the watcher: killed", e.getMessage());
        }
        assertEquals(List.of("START", "closed"), calls);
        Springs resumed = new Springs();
        try (Run run = Run.resume(resumed, path)) {
            assertEquals(20, run.getResumedFrom());
            assertEquals(digest, run.execute().getStateDigest());
        }
        assertArrayEquals(whole.energies.array(), resumed.energies.array());
    }

    @Test
    void constantsFactoriesAndDefaultsAreCalledAsThoseOfJava() {
        Population population = whole.population();
        var boundary = new Periodic(Box.centred(10.0, 10.0, 10.0));
        PopulationSums sums = new PopulationSums(null);
        sums.take(population);
        assertEquals(GranularTemperatureKt.granularTemperature(population, null), sums.getGranularTemperature());
        var pairs = new NearPairs(population, boundary, 0.0);
        int[] indices = {pairs.index(0), pairs.index(1), pairs.index(2)};
        Arrays.sort(indices);
        assertArrayEquals(new int[] {0, 1, 2}, indices);
        assertEquals(0.0, Overlap.deepest(population, boundary, 0.0).getDepth());
        assertEquals("time", SeriesColumns.TIME.getName());
        assertEquals(1.0, Epicycle.of(1.0, 0.0, 0.0, 0.0, -1.5, 0.0, 1.0).getGuidingX());
        assertEquals(1.0, Epicycle.guidingX(1.0, -1.5, 1.0));
        InlineLoop.INSTANCE.run(3, (worker, from, to) -> assertEquals(3, to - from));
    }
}
