/** All that is computed of a run. */
module daphnis.analysis {
    requires transitive daphnis.core;

    exports daphnis.analysis.brightness;
    exports daphnis.analysis.correlation;
    exports daphnis.analysis.diffusion;
    exports daphnis.analysis.flow;
    exports daphnis.analysis.input;
    exports daphnis.analysis.insitu;
    exports daphnis.analysis.moonlet;
    exports daphnis.analysis.neighbour;
    exports daphnis.analysis.occultation;
    exports daphnis.analysis.order;
    exports daphnis.analysis.profile;
    exports daphnis.analysis.series;
    exports daphnis.analysis.statistics;
    exports daphnis.analysis.streamline;
    exports daphnis.analysis.table;
    exports daphnis.analysis.theory;
    exports daphnis.analysis.transport;
    exports daphnis.analysis.wave;
}
