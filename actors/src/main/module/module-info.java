/** Engines on coroutines and on Pekko, and runs over several machines. */
@SuppressWarnings("requires-transitive-automatic")
module daphnis.actors {
    requires transitive daphnis.core;
    requires transitive kotlinx.coroutines.core;
    requires transitive pekko.actor;
    requires transitive pekko.actor.typed;
    requires transitive typesafe.config;
    requires pekko.cluster;
    requires pekko.remote;
    requires scala.library;
    requires java.management;
    // What Pekko uses, which has no descriptor.
    requires java.logging;
    requires java.naming;
    requires jdk.jfr;
    requires jdk.unsupported;

    exports daphnis.actors;
    exports daphnis.actors.coroutine;
    exports daphnis.actors.pekko;
    exports daphnis.actors.region;
    exports daphnis.cluster;
    exports daphnis.cluster.hosts;
    exports daphnis.cluster.security;
    exports daphnis.cluster.settings;

    // Classes that Pekko makes, by their names in cluster.conf.
    opens daphnis.cluster.downing to pekko.actor;
    opens daphnis.cluster.wire to pekko.actor;
}
