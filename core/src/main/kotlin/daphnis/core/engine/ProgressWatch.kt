package daphnis.core.engine

/** Notices inelastic collapse: more collisions than could be honest while time stands still to fifteen digits. */
internal class ProgressWatch {
    private var mark = 0.0
    private var events = 0L
    private var most = 0L
    private var resolution = 0.0

    fun start(spheres: Int, duration: Double) {
        mark = 0.0
        events = 0
        most = LEAST + A_SPHERE * spheres
        resolution = duration * RESOLUTION
    }

    fun check(time: Double, stepStart: Double) {
        if (time > mark + resolution) {
            mark = time
            events = 0
        } else if (++events > most) {
            throw CollapseException(
                "inelastic collapse at time ${stepStart + time}: $events collisions without time going on; " +
                    "set a collapse guard (floor speed or contact duration)",
            )
        }
    }

    private companion object {
        const val LEAST = 100_000L
        const val A_SPHERE = 100L
        const val RESOLUTION = 1e-13
    }
}
