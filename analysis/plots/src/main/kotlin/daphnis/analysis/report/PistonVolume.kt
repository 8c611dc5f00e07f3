package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.run.SeriesColumns
import daphnis.core.wall.Piston

/** The volume between walls of which some are pistons: the box says only where these were at the start. */
internal object PistonVolume {
    /** Whether any wall of the run of [study] is a piston. */
    fun isSeen(study: Study): Boolean = faces(study).isNotEmpty()

    private fun faces(study: Study) = (0 until FACES).filter { study.last.boundary.walls[it]?.motion is Piston }

    /** The volume, an area of discs, in the rows of `series.csv` since averages begin; null without such rows. */
    fun average(study: Study): BlockAverage? {
        val series = study.input.series ?: return null
        val pistons = faces(study)
        if (pistons.isEmpty() || pistons.any { SeriesColumns.PISTON_POSITION[it] !in series }) return null
        val time = series[SeriesColumns.TIME]
        val places = pistons.associateWith { series[SeriesColumns.PISTON_POSITION[it]] }
        val boundary = study.last.boundary
        fun at(face: Int, row: Int) =
            places[face]?.get(row) ?: boundary.walls[face]?.motion?.displacement(time[row]) ?: 0.0
        val rows = time.indices.filter { time[it] >= study.from }
        if (rows.isEmpty()) return null
        return BlockAverage.of(
            DoubleArray(rows.size) { k ->
                (0 until boundary.space.dimensions).fold(1.0) { volume, axis ->
                    volume * (boundary.box.length(axis) + at(2 * axis + 1, rows[k]) - at(2 * axis, rows[k]))
                }
            },
        )
    }

    private const val FACES = 6
}
