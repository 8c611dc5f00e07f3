package daphnis.analysis.movie

import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Png
import daphnis.analysis.plot.drawing
import daphnis.analysis.table.UnitNames

/**
 * Pictures of states as they come, such as those of a run that goes on: frames of a movie, each with the range of
 * colours that its own state needs. May be called from any thread.
 */
public class StatePicture(private val options: MovieOptions, private val units: UnitNames) {
    /** [state] as a PNG. @throws IllegalStateException when this Java cannot draw */
    public fun png(state: State): ByteArray = drawing {
        val survey = Survey(options)
        survey.look(state)
        survey.weigh(state)
        val scene = survey.scene(units, state.omega)
        val clock = Clock(scene.scale, doubleArrayOf(state.time))
        Png.encode(FramePainter(scene, Legend(scene)).paint(state, clock.text(state.time)))
    }
}
