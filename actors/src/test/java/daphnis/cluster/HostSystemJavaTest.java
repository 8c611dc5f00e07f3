package daphnis.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.typesafe.config.Config;
import com.typesafe.config.ConfigFactory;
import daphnis.cluster.security.Secret;
import daphnis.cluster.settings.HostConfig;
import daphnis.core.cluster.FleetEngines;
import daphnis.core.cluster.NodeWorks;
import daphnis.core.cluster.NodesAwaited;
import daphnis.core.run.Run;
import daphnis.core.scenario.BuiltIn;
import daphnis.core.scenario.Scenario;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.apache.pekko.actor.ActorSystem;
import org.apache.pekko.cluster.Cluster;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A node and runs in actor systems of a program in Java. */
@Timeout(300)
@Tag("thorough")
class HostSystemJavaTest {
    private static final String OWN = """
        pekko { loglevel = OFF, stdout-loglevel = OFF, loggers = [], daemonic = on }
        pekko.remote.artery.canonical { hostname = "127.0.0.1", port = 0 }
        pekko.cluster.jmx.enabled = off
        """;

    @TempDir Path home;

    private static ActorSystem system(Config needed) {
        Config own = ConfigFactory.parseString(OWN);
        return ActorSystem.create("host", ConfigFactory.load(own.withFallback(needed)));
    }

    @Test
    void runsOnActorSystemsOfTheProgramGiveTheBitsOfOneMachine() {
        Scenario scenario = BuiltIn.scenario("cooling-gas", List.of("until=0.5", "particles.count=200"));
        String alone;
        try (Run run = Run.start(scenario, "gas", home.resolve("alone"))) {
            alone = run.execute().getStateDigest();
        }
        Secret secret = Secret.of("a secret of the program", "here");
        ActorSystem forNode = system(HostConfig.node());
        ActorSystem forRuns = system(HostConfig.run());
        try {
            Cluster.get(forNode).join(Cluster.get(forNode).selfAddress());
            Cluster.get(forRuns).join(Cluster.get(forNode).selfAddress());
            try (ClusterNode node = ClusterNode.on(forNode, secret, 1, NodeWorks.ofRuns(), line -> {})) {
                for (String name : List.of("one", "two")) {
                    ClusterFleet fleet = ClusterFleet.on(forRuns, secret, name, line -> {});
                    new NodesAwaited(fleet, Duration.ofSeconds(90), line -> {}).await(1);
                    var builder = Run.builder(scenario).directory(home.resolve(name)).engines(new FleetEngines(fleet));
                    try (Run run = builder.start()) {
                        assertEquals(alone, run.execute().getStateDigest());
                    }
                }
            }
            assertFalse(forNode.getWhenTerminated().toCompletableFuture().isDone());
            assertFalse(forRuns.getWhenTerminated().toCompletableFuture().isDone());
        } finally {
            forNode.terminate();
            forRuns.terminate();
        }
    }
}
