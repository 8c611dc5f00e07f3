package daphnis.core.cluster.bricks

import daphnis.core.population.SphereColumns
import daphnis.core.step.PreparedStep

/**
 * What every node has to know to begin a step.
 *
 * @property key its first attempt
 * @property whole the step, measured for all spheres: refusals and bounds
 * @property total number of all spheres
 * @property widths of the halos in the first attempt
 * @property halt ends the step early
 */
internal class StepInput(
    val key: AttemptKey,
    val whole: PreparedStep,
    val total: Int,
    val widths: HaloWidths,
    val halt: Halt,
)

/** The spheres that a node holds at the start of a step: the entries [from] until [to] of [spheres]. */
internal class Held(val spheres: SphereColumns, val from: Int, val to: Int)
