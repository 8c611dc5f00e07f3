package daphnis.cluster.desk

import daphnis.cluster.hosts.HostPort
import daphnis.cluster.wire.Note

/** Carries notes to other processes; each may be lost. Returns at once. */
internal fun interface Courier {
    fun send(to: HostPort, note: Note)
}
