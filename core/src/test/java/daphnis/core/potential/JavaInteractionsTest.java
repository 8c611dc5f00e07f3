package daphnis.core.potential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import daphnis.core.Simulation;
import daphnis.core.boundary.BoundaryConditions;
import daphnis.core.engine.CollisionForcing;
import daphnis.core.population.Population;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The Java of interactions in docs/library.md. */
class JavaInteractionsTest {
    @Test
    void bondsOfOneMaterial() {
        // example: bondsInJava
        PairInteractions bonds = new PairInteractions(null).between(0, 0, new Bridge(1.1, 0.2, 0.5, 4.0 / 3));
        CollisionForcing collisions = CollisionForcing.builder(speed -> 0.9).interactions(bonds).build();
        // end
        assertNull(bonds.getOthers());
        // Two pairs meet, of which the first has an edge to come to as it recedes.
        double[] zero = new double[4];
        Population population = Population.builder()
            .positions(new double[] {0, 1.05, 10, 11.05}, zero, zero)
            .velocities(new double[] {1, -1, 1, -1}, zero, zero)
            .radius(0.5)
            .mass(1.0)
            .materials(new int[] {0, 0, 0, 1}, List.of("wet", "dry"))
            .build();
        try (Simulation simulation = Simulation.builder(population)
                .boundary(BoundaryConditions.open())
                .collisions(collisions)
                .timeStep(0.1)
                .build()) {
            while (simulation.getTime() < 0.95) simulation.advance();
        }
        assertEquals(2, collisions.getCounters().getCollisions());
        assertEquals(1, collisions.getCounters().getEdgeEvents());
    }
}
