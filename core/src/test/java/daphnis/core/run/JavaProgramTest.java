package daphnis.core.run;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import daphnis.core.Engines;
import daphnis.core.Opening;
import daphnis.core.Output;
import daphnis.core.OutputState;
import daphnis.core.Simulation;
import daphnis.core.boundary.BoundaryConditions;
import daphnis.core.boundary.Box;
import daphnis.core.format.Snapshot;
import daphnis.core.population.Conserved;
import daphnis.core.population.Population;
import daphnis.core.scenario.BuiltIn;
import daphnis.core.input.InputException;
import daphnis.core.scenario.OutputSpec;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A program in Java with a law, a force and an output of its own in a run directory. */
class JavaProgramTest {
    @TempDir Path home;

    /** Spheres on springs in a ball, with a law, a force and a boundary of their own. */
    static class Springs implements Program {
        final Energies energies = new Energies();

        @Override public String getName() { return "springs"; }

        @Override public String getVersion() { return "1"; }

        @Override public double getUntil() { return 4.0; }

        @Override public OutputSpec getOutput() {
            return OutputSpec.builder().snapshotEvery(10).checkpointEvery(10).build();
        }

        @Override public Map<String, Output> outputs() { return Map.of("energies", energies); }

        @Override public Population population() {
            double[] x = {-3.0, 0.0, 3.0};
            double[] vx = {1.0, 0.0, -0.5};
            double[] zero = new double[3];
            return Population.builder()
                .positions(x, zero, zero)
                .velocities(vx, zero, zero)
                .radius(1.0)
                .mass(1.0)
                .build();
        }

        @Override public Simulation simulation(Population population) {
            return Simulation.builder(population)
                .boundary(new Ball(2.5))
                .restitution(speed -> 1 / (1 + 0.1 * speed))
                .timeStep(0.1)
                .kick((p, time, duration) -> {
                    for (int k = 0; k < p.getSize(); k++) p.getVx()[k] -= 0.1 * duration * p.getX()[k];
                })
                .build();
        }
    }

    /** Turns back, at the end of a step, what has left it. */
    record Ball(double radius) implements BoundaryConditions {
        @Override public Box getBox() { return Box.UNBOUNDED; }

        @Override public void endStep(Population p, double time) {
            double[] x = p.getX();
            double[] vx = p.getVx();
            for (int k = 0; k < p.getSize(); k++) {
                if (Math.abs(x[k]) > radius && x[k] * vx[k] > 0) vx[k] = -vx[k];
            }
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

    @Test
    void withoutItsLawItsBoundaryOrItsForceTheProgramIsAnother() {
        String digest = wholeDigest();
        for (String part : List.of("law", "boundary", "force", "none")) {
            Springs other = new Springs() {
                @Override public Simulation simulation(Population population) {
                    var parts = Simulation.builder(population).timeStep(0.1);
                    parts.boundary(part.equals("boundary") ? BoundaryConditions.open() : new Ball(2.5));
                    parts.restitution(part.equals("law") ? speed -> 1.0 : speed -> 1 / (1 + 0.1 * speed));
                    if (!part.equals("force")) super.simulation(population).getForces().forEach(parts::force);
                    return parts.build();
                }
            };
            try (Run run = Run.builder(other).directory(home.resolve(part)).start()) {
                assertEquals(part.equals("none"), run.execute().getStateDigest().equals(digest), part);
            }
        }
    }

    @Test
    void aRunIsReplacedOrContinuedWithALossOnlyWhenThatIsSaid() throws IOException {
        Path path = home.resolve("lossy");
        var program = Run.builder(new Springs()).directory(path).cancelled(() -> true);
        for (var parts : List.of(program, program.replace())) {
            try (Run run = parts.start()) {
                assertFalse(run.execute().getFinished());
            }
        }
        Files.writeString(path.resolve("series.csv"), "");
        var next = Run.builder(new Springs()).directory(path);
        assertThrows(InputException.class, next::resume);
        try (Run run = next.acceptLoss().resume()) {
            assertFalse(run.getNotices().isEmpty());
        }
        var scenario = BuiltIn.scenario("cooling-gas", List.of("particles.count=20", "until=0.1"));
        Path gas = home.resolve("gas");
        try (Run run = Run.builder(scenario).directory(gas).cancelled(() -> true).start()) {
            run.execute();
        }
        Files.writeString(gas.resolve("series.csv"), "");
        var engines = Engines.factory();
        assertThrows(InputException.class, () -> Run.resuming(gas).engines(engines).resume());
        try (Run run = Run.resuming(gas).acceptLoss().resume()) {
            assertFalse(run.getNotices().isEmpty());
        }
    }

    @Test
    void whatBelongsToAStartOrAResumeAloneIsRefusedAtTheOther() {
        Path path = home.resolve("none");
        for (var refusal : Map.<String, Runnable>of(
                "the run has no directory; give directory(…)", () -> Run.builder(whole).start(),
                "acceptLoss() is for a run that continues; start() begins one",
                () -> Run.builder(whole).directory(path).acceptLoss().start(),
                "replace() is for a run that starts; resume() continues the one that is there",
                () -> Run.builder(whole).directory(path).replace().resume()).entrySet()) {
            var e = assertThrows(IllegalArgumentException.class, refusal.getValue()::run);
            assertEquals(refusal.getKey(), e.getMessage());
        }
        assertFalse(Files.exists(path));
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
        try (Run run = Run.builder(resumed).directory(path).resume()) {
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
        Output first = isStart ? failing : new Failing("", null);
        var scenario = BuiltIn.scenario("cooling-gas", List.of("particles.count=20", "until=0.1"));
        try (Run run = Run.builder(scenario).directory(path).replace().output("java", first).start()) {
            run.execute();
        }
        if (!isStart) Run.resuming(path).output("java", failing).resume().close();
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
}
