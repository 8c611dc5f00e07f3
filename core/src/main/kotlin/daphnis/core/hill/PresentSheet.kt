package daphnis.core.hill

import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ImageShear
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.wrap
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population

/**
 * What a perturbed [sheet] is in a step that begins at [start] and lasts [duration], or, with a duration of 0, at that
 * time. Immutable.
 */
internal class PresentSheet(
    private val sheet: HillSheet,
    private val path: ImagePath,
    private val start: Double,
    private val duration: Double,
) : PerSphereBoundary {
    override val box: Box = boxAt(start)
    private val velocityX = path.velocityX(start, duration)
    private val velocityY = path.velocityY(start, duration)
    override val meanFlow: MeanFlow = MeanFlow(0, 1, velocityY / box.length(0), velocityX / box.length(0))
    override val shear: ImageShear = ImageShear.at(box, path.y(start), start, velocityX, velocityY)

    private fun boxAt(time: Double): Box = sheet.box.let {
        val by = path.widening(time)
        Box(it.lowerX * by, it.lowerY, it.lowerZ, it.upperX * by, it.upperY, it.upperZ, it.space)
    }

    override fun contactFaces(axis: Int): ContactFaces = sheet.contactFaces(axis)

    override fun during(start: Double, duration: Double): PresentSheet = PresentSheet(sheet, path, start, duration)

    /** Into the box that there is at [time], with the velocities of the chords that end there. */
    override fun endStep(population: Population, time: Double, from: Int, to: Int) {
        val then = boxAt(time)
        ImageShear.at(then, path.y(time), time, velocityX, velocityY).wrap(population, time, from, to)
        wrap(population, 1, then, from, to)
    }
}
