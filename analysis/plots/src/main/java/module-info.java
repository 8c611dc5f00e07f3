/** Reports, pictures, plots and movies. */
module daphnis.plots {
    requires transitive daphnis.analysis;
    requires java.desktop;
    requires jcodec;

    exports daphnis.analysis.movie;
    exports daphnis.analysis.plot;
    exports daphnis.analysis.report;
    exports daphnis.analysis.sweep;
}
