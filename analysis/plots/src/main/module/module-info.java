/** Reports, pictures, plots and movies. */
module daphnis.plots {
    requires transitive daphnis.analysis;
    requires java.desktop;
    // Its jar does not say the name of its module, so build tools may leave it on the class path: Mp4File.
    requires static jcodec;

    exports daphnis.analysis.movie;
    exports daphnis.analysis.plot;
    exports daphnis.analysis.report;
    exports daphnis.analysis.sweep;
}
