package daphnis.cluster.system

import daphnis.cluster.desk.Greeter
import daphnis.core.run.Version

/** What all processes of a cluster must have in common. */
internal object Protocol {
    /** Changes with what processes say to each other, in this module or in the work of a crew. */
    private const val NUMBER = 5

    val build: Greeter.Build get() = Greeter.Build(Version.text, NUMBER)
}
