package daphnis.core;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import daphnis.core.run.Run;
import daphnis.core.run.RunDirectory;
import daphnis.core.run.Summary;
import daphnis.core.scenario.BuiltIn;
import daphnis.core.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The pipeline of docs/examples/java.md, compiled and run. GuideExamplesTest compares the text. */
class JavaBatchTest {
    @TempDir Path home;

    // example: batch
    /** Runs of a gas that cools, one for each coefficient of restitution, some at a time; each a directory in home. */
    static class Batch {
        private final Path home;
        private final int jobs;
        private final String[] settings;
        private final AtomicBoolean isStopped = new AtomicBoolean();

        Batch(Path home, int jobs, String... settings) {
            this.home = home;
            this.jobs = jobs;
            this.settings = settings;
        }

        /** From any thread: each run ends after its step, with a checkpoint. */
        void stop() {
            isStopped.set(true);
        }

        /** Starts what is new, goes on with what was stopped, and leaves alone what is complete. */
        Map<Double, Summary> run(double... coefficients) throws InterruptedException, ExecutionException {
            isStopped.set(false);
            ExecutorService pool = Executors.newFixedThreadPool(jobs);
            try {
                Map<Double, Future<Summary>> futures = new LinkedHashMap<>();
                for (double e : coefficients) futures.put(e, pool.submit(() -> one(e)));
                Map<Double, Summary> summaries = new LinkedHashMap<>();
                for (double e : coefficients) summaries.put(e, futures.get(e).get());
                return summaries;
            } finally {
                stop(); // where one has failed, the others need not go on
                pool.shutdown();
            }
        }

        private Summary one(double coefficient) {
            Path path = home.resolve("e=" + coefficient);
            RunDirectory directory = new RunDirectory(path);
            if (Files.exists(directory.getSummary())) {
                Summary summary = Run.open(path).summary();
                if (summary.getFinished()) return summary;
            }
            try (Run run = Files.exists(path) ? goingOn(path) : starting(path, coefficient)) {
                return run.execute();
            }
        }

        private Run starting(Path path, double coefficient) {
            Scenario scenario = BuiltIn.scenario("cooling-gas", List.of(settings));
            return Run.builder(scenario)
                .set("restitution.coefficient=" + coefficient)
                .directory(path)
                .threads(1)
                .cancelled(isStopped::get)
                .start();
        }

        private Run goingOn(Path path) {
            return Run.resuming(path).cancelled(isStopped::get).resume();
        }
    }
    // end

    // example: table
    /** How far the gas has cooled, and d ln T/dC = −(1 − ε²)/3 of Maxwellian velocities, C collisions of a sphere. */
    static List<String> table(Map<Double, Summary> summaries) {
        List<String> lines = new ArrayList<>(List.of("restitution,collisions_of_a_sphere,ln_temperature,theory"));
        summaries.forEach((e, summary) -> {
            double c = 2.0 * summary.getCollisions() / summary.getParticles();
            double seen = Math.log(summary.getTemperature());
            lines.add(String.format(Locale.ROOT, "%s,%.2f,%.3f,%.3f", e, c, seen, -(1 - e * e) / 3 * c));
        });
        return lines;
    }
    // end

    @Test
    void aBatchIsStoppedAndGoesOn() throws InterruptedException, ExecutionException, IOException {
        boolean isFull = "full".equals(System.getProperty("daphnis.physics"));
        String count = "particles.count=" + (isFull ? 2000 : 200);
        String until = "until=" + (isFull ? 100 : 20);
        double[] coefficients = {0.8, 0.9, 0.95};
        Path csv = home.resolve("cooling.csv");
        // example: batchRun
        Batch batch = new Batch(home, 2, count, until, "velocities.exact=true", "output.checkpointEvery=50");
        Thread deadline = new Thread(() -> {
            try {
                Thread.sleep(500);
                batch.stop();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        deadline.start();
        Map<Double, Summary> early = batch.run(coefficients);
        deadline.join();
        System.out.println(early.values().stream().filter(Summary::getFinished).count() + " complete");
        List<String> lines = table(batch.run(coefficients)); // the rest
        Files.write(csv, lines);
        lines.forEach(System.out::println);
        // end
        Map<Double, Summary> all = batch.run(coefficients);
        Batch whole = new Batch(home.resolve("whole"), 1, count, until, "velocities.exact=true");
        Map<Double, Summary> once = whole.run(coefficients);
        for (double e : coefficients) {
            assertTrue(all.get(e).getFinished());
            assertEquals(once.get(e).getStateDigest(), all.get(e).getStateDigest());
            double c = 2.0 * all.get(e).getCollisions() / all.get(e).getParticles();
            assertEquals(-(1 - e * e) / 3 * c, Math.log(all.get(e).getTemperature()), 0.15);
        }
        assertEquals(4, Files.readAllLines(csv).size());
        assertFalse(lines.get(1).contains("NaN"));
    }
}
