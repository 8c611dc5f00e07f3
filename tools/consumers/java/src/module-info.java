module consumer {
    requires daphnis.core;
    requires daphnis.analysis;
}
