/** Event-driven simulation of hard spheres. Every package of the API is exported: ModulesTest. */
module daphnis.core {
    requires transitive kotlin.stdlib;
    requires transitive kotlinx.serialization.core;
    requires transitive kotlinx.serialization.json;
    requires io.jhdf;
    // What libraries without a descriptor use: that of HDF5, and one that it unpacks with.
    requires org.slf4j;
    requires org.apache.commons.lang3;
    requires com.ning.compress.lzf;
    requires jdk.unsupported;

    uses daphnis.core.input.Ingredients;

    exports daphnis.core;
    exports daphnis.core.api;
    exports daphnis.core.boundary;
    exports daphnis.core.cluster;
    exports daphnis.core.collision;
    exports daphnis.core.compression;
    exports daphnis.core.engine;
    exports daphnis.core.engine.horizon;
    exports daphnis.core.engine.islands;
    exports daphnis.core.engine.threadpool;
    exports daphnis.core.force;
    exports daphnis.core.force.thermostat;
    exports daphnis.core.format;
    exports daphnis.core.growth;
    exports daphnis.core.hill;
    exports daphnis.core.initial;
    exports daphnis.core.input;
    exports daphnis.core.merging;
    exports daphnis.core.orbit;
    exports daphnis.core.parallel;
    exports daphnis.core.population;
    exports daphnis.core.potential;
    exports daphnis.core.queue;
    exports daphnis.core.run;
    exports daphnis.core.scenario;
    exports daphnis.core.search;
    exports daphnis.core.source;
    exports daphnis.core.space;
    exports daphnis.core.step;
    exports daphnis.core.surface;
    exports daphnis.core.swap;
    exports daphnis.core.table;
    exports daphnis.core.wall;
    exports daphnis.core.wave;
}
