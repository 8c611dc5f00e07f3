package daphnis.core.population

/**
 * What has a state of its own besides the spheres, which goes on from step to step: it is in a checkpoint, goes to the
 * nodes of a run, and is put back when a step is taken back.
 */
public interface Carried {
    /** The state at the end of the last step, as numbers of its own; always as many. Setting it takes it over. */
    public var carried: DoubleArray
}
