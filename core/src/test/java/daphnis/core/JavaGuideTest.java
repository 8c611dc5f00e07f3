package daphnis.core;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import daphnis.core.boundary.BoundaryConditions;
import daphnis.core.boundary.Box;
import daphnis.core.boundary.Open;
import daphnis.core.boundary.Periodic;
import daphnis.core.collision.CollapseGuard;
import daphnis.core.collision.FloorSpeedGuard;
import daphnis.core.collision.NoGuard;
import daphnis.core.engine.CollisionForcing;
import daphnis.core.engine.SerialEngine;
import daphnis.core.force.Kick;
import daphnis.core.format.ExportOptions;
import daphnis.core.format.FormatException;
import daphnis.core.format.SnapshotFormats;
import daphnis.core.hill.Epicycle;
import daphnis.core.parallel.RangeLoop;
import daphnis.core.population.Digest;
import daphnis.core.population.GranularTemperature;
import daphnis.core.population.Population;
import daphnis.core.population.PopulationSums;
import daphnis.core.run.RecordedRun;
import daphnis.core.run.Run;
import daphnis.core.run.RunDirectory;
import daphnis.core.run.RunOrigin;
import daphnis.core.run.SeriesColumns;
import daphnis.core.run.Summary;
import daphnis.core.scenario.BuiltIn;
import daphnis.core.scenario.OutputSpec;
import daphnis.core.scenario.Scenario;
import daphnis.core.search.NearPairs;
import daphnis.core.search.Overlap;
import daphnis.core.search.SearchStructure;
import daphnis.core.surface.ContactLaw;
import daphnis.core.surface.SurfaceContact;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The Java of docs/library.md and README.md, compiled and run. LibraryGuideTest compares the text. */
class JavaGuideTest {
    @TempDir Path home;

    @Test
    void theProgramOfTheFirstPage() {
        Path directory = home.resolve("gas");
        // example: readmeInJava
        Scenario scenario = BuiltIn.scenario("cooling-gas", List.of("particles.count=200"));
        try (Run run = Run.builder(scenario).directory(directory).until(2.0).start()) {
            Summary summary = run.execute();
            System.out.println(summary.getCollisions() + " collisions, digest " + summary.getStateDigest());
        }
        // end
        Summary summary = Run.open(directory).summary();
        assertNotNull(summary);
        assertTrue(summary.getFinished() && summary.getCollisions() > 0);
        assertEquals(2.0, summary.getTime(), 1e-9);
    }

    @Test
    void aSimulationOfPartsWithNames() {
        // example: simulationInJava
        double[] x = {-3.0, 0.0, 3.0};
        double[] vx = {1.0, 0.0, -0.5};
        double[] zero = new double[3];
        Population population = Population.builder()
            .positions(x, zero, zero)
            .velocities(vx, zero, zero)
            .radius(0.5)
            .mass(1.0)
            .build();
        CollisionForcing collisions = CollisionForcing.builder(speed -> 1 / (1 + speed))
            .guard(new FloorSpeedGuard(1e-6))
            .engine("islands", 2, Engines.factory())
            .build();
        List<Double> temperatures = new ArrayList<>();
        try (Simulation simulation = Simulation.builder(population)
                .boundary(new Periodic(Box.centred(10.0, 10.0, 10.0)))
                .collisions(collisions)
                .timeStep(0.1)
                .kick((p, time, duration) -> p.getVz()[p.indexOf(1)] += 0.01 * duration)
                .output(s -> temperatures.add(GranularTemperature.of(s.getPopulation(), null)))
                .build()) {
            while (simulation.getTime() < 5.0) simulation.advance();
        }
        System.out.println(collisions.getCounters().getCollisions() + " collisions, " + Digest.stateDigest(population));
        // end
        assertEquals(51, temperatures.size());
        assertTrue(collisions.getCounters().getCollisions() > 0);
        assertEquals(0.05, Arrays.stream(population.getVz()).sum(), 1e-12);
        assertThrows(IllegalStateException.class, () -> collisions.getEngine().getLoop().run(1, (w, a, b) -> { }));
    }

    @Test
    void aRunWithEverythingOfTheCommandLine() {
        Path directory = home.resolve("gas");
        Path longer = home.resolve("longer");
        Scenario scenario = BuiltIn.scenario("cooling-gas", List.of("particles.count=200", "timeStep.dt=0.05"));
        // example: runInJava
        AtomicBoolean isEnough = new AtomicBoolean();
        try (Run run = Run.builder(scenario)
                .directory(directory)
                .set("output.snapshotEvery=5")
                .engine("islands")
                .threads(2)
                .until(1.0)
                .output("watch", s -> isEnough.set(s.getStep() >= 10))
                .cancelled(isEnough::get)
                .start()) {
            run.execute();
        }
        try (Run run = Run.resuming(directory).resume()) {
            run.execute();
        }
        RecordedRun recorded = Run.open(directory);
        RunOrigin origin = new RunOrigin(recorded, recorded.at(0.5));
        try (Run run = Run.builder(scenario).directory(longer).from(origin).steps(20).start()) {
            System.out.println(run.execute().getStateDigest());
        }
        // end
        Summary first = recorded.summary();
        assertTrue(first != null && first.getFinished() && first.getSteps() == 20);
        assertEquals(List.of("islands", 2), List.of(first.getEngine(), first.getThreads()));
        Summary second = Run.open(longer).summary();
        assertTrue(second != null && second.getFinished() && second.getSteps() == 20);
        assertEquals(1.5, second.getTime(), 1e-12);
        try (Run run = Run.builder(scenario).directory(longer).replace().steps(1).start()) {
            assertEquals(1, run.execute().getSteps());
        }
    }

    @Test
    void aCancelledRunIsUnfinishedUntilItIsResumed() {
        Path path = home.resolve("gas");
        Scenario scenario = BuiltIn.scenario("cooling-gas", List.of("particles.count=50", "timeStep.dt=0.05"));
        try (Run run = Run.builder(scenario).directory(path).until(0.5).cancelled(() -> true).start()) {
            assertFalse(run.execute().getFinished());
        }
        try (Run run = Run.resuming(path).cancelled(() -> true).resume()) {
            assertFalse(run.execute().getFinished());
        }
        List<Long> steps = new ArrayList<>();
        try (Run run = Run.resuming(path).until(0.2).output("steps", s -> steps.add(s.getStep())).resume()) {
            assertEquals(0.2, run.execute().getTime(), 1e-12);
        }
        assertEquals(List.of(1L, 2L, 3L, 4L), steps);
    }

    /** All that a Java program names without `INSTANCE`, `Companion`, or the name of a file. */
    @Test
    void objectsFactoriesAndDefaultsAreCalledAsThoseOfJava() {
        assertSame(Open.INSTANCE, BoundaryConditions.open());
        assertSame(NoGuard.INSTANCE, CollapseGuard.none());
        RangeLoop.inline().run(3, (worker, from, to) -> assertEquals(3, to - from));
        assertEquals(List.of("horizon", "islands", "thread-pool", "serial"), Engines.getNames());
        try (var engine = Engines.create("islands", 2)) {
            assertTrue(engine != null && engine.getThreads() == 2);
        }
        assertEquals(Engines.getNames(), Engines.factory().getNames());
        assertEquals("time", SeriesColumns.TIME.getName());
        assertEquals(1.0, Epicycle.of(1.0, 0.0, 0.0, 0.0, -1.5, 0.0, 1.0).getGuidingX());
        assertEquals(1.0, Epicycle.guidingX(1.0, -1.5, 1.0));
        OutputSpec spec = OutputSpec.builder().snapshotEvery(7).collisionLog().build();
        assertEquals(7, spec.getSnapshotEvery());
        assertEquals(new OutputSpec().getCheckpointEvery(), spec.getCheckpointEvery());
        assertTrue(spec.getCollisionLog());
    }

    @Test
    void pairsAreTakenByALambda() {
        Population population = pair(0.9);
        var boundary = new Periodic(Box.centred(10.0, 10.0, 10.0));
        PopulationSums sums = new PopulationSums(null);
        sums.take(population);
        assertEquals(GranularTemperature.of(population, null), sums.getGranularTemperature());
        assertEquals(0.1, Overlap.deepest(population, boundary, 0.0).getDepth(), 1e-12);
        var pairs = new NearPairs(population, boundary, 0.0);
        List<Double> distances = new ArrayList<>();
        var runs = pairs.runs();
        for (int slot = 0; slot < 2; slot++) {
            pairs.forEach(runs, slot, 0.5, (first, second, dx, dy, dz) -> distances.add(Math.abs(dx)));
        }
        assertEquals(List.of(0.9), distances);
    }

    @Test
    void statesAreExportedFromAnIterable() throws IOException {
        Path directory = home.resolve("gas");
        Scenario scenario = BuiltIn.scenario("cooling-gas", List.of("particles.count=20", "until=0.2"));
        try (Run run = Run.builder(scenario).directory(directory).start()) {
            run.execute();
        }
        assertThrows(FormatException.class, () -> new RunDirectory(directory).readSnapshot(7));
        assertThrows(FormatException.class, () -> SnapshotFormats.named("doc"));
        // example: exportInJava
        var options = new ExportOptions("1.0");
        SnapshotFormats.named("xyz").export(Run.open(directory).states(), directory, options);
        // end
        try (var files = Files.list(directory)) {
            assertTrue(files.anyMatch(file -> file.toString().endsWith("xyz")));
        }
    }

    /** Two spheres of radius 0.5 at this distance along x. */
    private static Population pair(double distance) {
        double[] zero = new double[2];
        return Population.builder()
            .positions(new double[] {0.0, distance}, zero, zero)
            .radii(new double[] {0.5, 0.5})
            .masses(new double[] {1.0, 2.0})
            .ids(new int[] {4, 9})
            .build();
    }

    @Test
    void aPopulationHasArraysOfItsOwn() {
        double[] one = {1.0};
        int[] id = {3};
        var spheres = Population.builder().positions(one, one, one).velocities(one, one, one).radii(one).masses(one);
        Population first = spheres.ids(id).build();
        Population second = spheres.build();
        for (double[] column : List.of(
                first.getX(), first.getY(), first.getZ(), first.getVx(), first.getVy(), first.getVz(),
                first.getRadius(), first.getMass())) {
            column[0] = 2.0;
        }
        first.getId()[0] = 4;
        assertEquals(List.of(1.0, 3), List.of(one[0], id[0]));
        assertEquals(1.0, second.getX()[0] * second.getVz()[0] * second.getRadius()[0] * second.getMass()[0]);
        assertEquals(3, second.getId()[0]);
    }

    @Test
    void aForcingHasTheEngineAndTheRecordThatItWasGiven() {
        SerialEngine engine = new SerialEngine();
        var parts = CollisionForcing.builder(speed -> 0.5).search(SearchStructure.LEVELS);
        assertNull(parts.build().getRecord());
        CollisionForcing collisions = parts.engine(engine).recordCollisions().build();
        assertSame(engine, collisions.getEngine());
        assertNotNull(collisions.getRecord());
    }

    private static void refuses(String message, Runnable call) {
        var e = assertThrows(IllegalArgumentException.class, call::run);
        assertEquals(message, e.getMessage());
    }

    @Test
    void whatIsMissingOrContradictsItselfIsSaidInOneSentence() {
        refuses("the spheres have no positions; give positions(x, y, z)", () -> Population.builder().build());
        double[] one = {1.0};
        var spheres = Population.builder().positions(one, one, one);
        refuses("the spheres have no radii; give radius(…) or radii(…)", spheres::build);
        refuses("the spheres have no masses; give mass(…) or masses(…)", spheres.radius(1.0)::build);
        Population population = spheres.mass(1.0).build();
        assertEquals(0.0, population.getVx()[0]);

        var parts = Simulation.builder(population);
        refuses("the simulation has no boundary; give boundary(…), such as Open", parts::build);
        parts.boundary(BoundaryConditions.open());
        String collide = "the simulation does not say how spheres collide; ";
        refuses(collide + "give restitution(…), collisions(…) or withoutCollisions()", parts::build);
        parts.withoutCollisions();
        refuses("the simulation has no time step; give timeStep(…)", parts::build);
        parts.timeStep(p -> 0.5);
        try (Simulation simulation = parts.startTime(2.0).startStep(4, 1.0).build()) {
            simulation.advance();
            assertEquals(List.of(2.5, 1.0), List.of(simulation.getTime(), simulation.getRunStart()));
            assertEquals(5, simulation.getStep());
        }
        parts.restitution(speed -> 0.5);
        refuses("restitution(…) and withoutCollisions() contradict each other; one of them is enough", parts::build);
        refuses(
            "there is no engine 'snail'; known: horizon, islands, thread-pool, serial",
            () -> CollisionForcing.builder(speed -> 0.5).engine("snail", 1, Engines.factory()));
    }

    @Test
    void aRunThatContradictsItselfLeavesNoDirectory() {
        Scenario scenario = BuiltIn.scenario("cooling-gas");
        refuses("the run has no directory; give directory(…)", () -> Run.builder(scenario).start());
        Path path = home.resolve("none");
        refuses(
            "until(…) and steps(…) both say where the run ends; give one of them",
            () -> Run.builder(scenario).directory(path).until(1.0).steps(5).start());
        refuses(
            "two outputs are called 'a'; each needs its own name",
            () -> Run.builder(scenario).output("a", s -> { }).output("a", s -> { }));
        for (String wrong : List.of("steps: is 0; it must be at least 1", "mine: engine.name: is \"snail\"")) {
            var run = Run.builder(scenario).directory(path).source("mine");
            if (wrong.startsWith("steps")) run.steps(0); else run.engine("snail");
            var e = assertThrows(RuntimeException.class, run::start);
            assertTrue(e.getMessage().startsWith(wrong), e.getMessage());
        }
        assertFalse(Files.exists(path));
    }

    @Test
    void aLawSaysBothCoefficients() {
        double[] x = {-3.0, 0.0, 30.0};
        double[] vx = {4.0, 0.0, 0.0};
        double[] y = {0.0, 1.0, 0.0};
        double[] zero = new double[3];
        Population smooth = Population.builder()
            .positions(x, y, zero).velocities(vx, zero, zero).radius(1.0).masses(new double[] {3.0, 4.0, 1.0}).build();
        // example: contactLawInJava
        ContactLaw dusty = new ContactLaw() {
            @Override public boolean isRough() { return true; } // β is not always −1

            @Override public double restitution(SurfaceContact contact) {
                return contact.getReducedMass() > 1 ? 0.9 : 0.5;
            }

            @Override public double roughness(SurfaceContact contact) { // asked after ε, where surfaces slide
                return contact.getTangentialSpeed() > contact.getNormalSpeed() ? 0.5 : -contact.getRestitution();
            }
        };
        double[] none = new double[3];
        Simulation simulation = Simulation.builder(smooth.withSpin(none, none, none))
            .boundary(BoundaryConditions.open())
            .contactLaw(dusty)
            .timeStep(0.1)
            .build();
        // end
        while (simulation.getTime() < 1.0) simulation.advance();
        assertEquals(1, simulation.getCollisions().getCounters().getCollisions());
        // Spins by equal impulses on equal radii are as the inverses of the masses.
        Population after = simulation.getPopulation();
        double[] w = after.getWz();
        assertEquals(4.0 / 3, w[after.indexOf(0)] / w[after.indexOf(1)], 1e-12);
        assertEquals(0.9, dusty.restitution(SurfaceContact.headOn(1.0, 1.0, 3.0)));
        assertEquals(0.5, dusty.restitution(SurfaceContact.headOn(1.0, 1.0, 1.0)));
        simulation.close();
        CollisionForcing forcing = CollisionForcing.builder(dusty).guard(new FloorSpeedGuard(9.0)).build();
        try (Simulation guarded = Simulation.builder(smooth.withSpin(none, none, none))
                .boundary(BoundaryConditions.open()).collisions(forcing).timeStep(1.0).build()) {
            guarded.advance();
            assertEquals(1, forcing.getCounters().getGuardActivations());
        }
        refuses(
            "contactLaw(…) and withoutCollisions() contradict each other; one of them is enough",
            Simulation.builder(smooth).boundary(BoundaryConditions.open()).timeStep(1.0).contactLaw(dusty)
                .withoutCollisions()::build);
    }

    @Test
    void aForceIsALambdaOrAnObject() {
        Kick still = (p, time, duration) -> { };
        try (Simulation simulation = Simulation.builder(pair(2.0))
                .boundary(BoundaryConditions.open())
                .restitution(speed -> 1.0)
                .timeStep(1.0)
                .force(still)
                .build()) {
            assertEquals(List.of(still), simulation.getForces());
        }
    }
}
