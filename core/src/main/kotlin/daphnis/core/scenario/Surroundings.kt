package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.input.InputException
import daphnis.core.input.UnitsSpec
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies

/**
 * Space and time of a scenario, without a population.
 *
 * @property box where spheres are placed; that of [boundary] unless it is open
 * @property boundary without what forces add, such as the surface of a moon
 * @property frequencies of orbits in the frame; null without a frame
 * @property end time at which the run ends
 * @property timeStep not an [TimeStepSpec.OrbitFraction]
 */
public class Surroundings private constructor(
    internal val box: Box,
    public val boundary: BoundaryConditions,
    public val frequencies: OrbitalFrequencies?,
    public val end: Double,
    public val timeStep: TimeStepSpec,
) {
    /** Angular speed of the frame in radians per unit of time; null without a frame. */
    public val angularSpeed: Double? get() = frequencies?.omega

    public companion object {
        /**
         * Makes and checks them.
         *
         * @param source what to call the scenario in messages
         * @throws InputException for anything that is wrong
         */
        @JvmStatic
        public fun of(scenario: Scenario, source: String): Surroundings {
            val check = ValueCheck(source)
            checkUnits(scenario.units, check)
            val times = FrameSetup.times(scenario, source)
            val frequencies = FrameSetup.frequencies(scenario, source)
            checkEnd(scenario, times.end, check)
            val box = box(scenario, check)
            val boundary = scenario.boundary.conditions(box, frequencies, check, scenario.seed)
            FrameSetup.checkFaces(scenario, boundary, frequencies, check)
            val around = GrowthSetup(scenario, check).boundary(boundary, box)
            return Surroundings(box, around, frequencies, times.end, times.timeStep)
        }

        private fun checkUnits(units: UnitsSpec, check: ValueCheck) {
            check.positive("units.speedInCmPerSecond", units.speedInCmPerSecond)
            units.lengthInMetres?.let { check.positive("units.lengthInMetres", it) }
            check.positive("units.massInKg", units.massInKg)
        }

        private fun checkEnd(scenario: Scenario, end: Double, check: ValueCheck) {
            val start = scenario.startTime
            check.that("until", end, end > start && end.isFinite()) {
                if (start == 0.0) "must be > 0" else "must be later than placement.time, $start, where the run starts"
            }
        }

        private fun box(scenario: Scenario, check: ValueCheck): Box {
            val lengths = scenario.box.lengths
            val dimensions = scenario.dimensions
            check.that("dimensions", dimensions, dimensions == 2 || dimensions == 3) { "must be 2 or 3" }
            check.that("box.lengths", lengths, lengths.size == dimensions) {
                if (dimensions == 2) {
                    "must be two numbers, the edges along x and y, with dimensions 2"
                } else {
                    val flat = if (lengths.size == 2) "; discs in a plane need dimensions 2" else ""
                    "must be three numbers, the edges along x, y and z$flat"
                }
            }
            lengths.forEachIndexed { k, length -> check.extent("box.lengths[$k]", length) }
            val box = if (dimensions == 2) {
                check.must("frame", scenario.frame == null) {
                    "is of a ring, and needs dimensions 3; discs in a plane have no frame"
                }
                Box.flat(lengths[0], lengths[1])
            } else {
                Box.centred(lengths[0], lengths[1], lengths[2])
            }
            check.that("box.lengths", lengths, box.volume > 0 && box.volume.isFinite()) {
                "give a volume of ${box.volume}; it must be positive and finite"
            }
            return box
        }
    }
}
