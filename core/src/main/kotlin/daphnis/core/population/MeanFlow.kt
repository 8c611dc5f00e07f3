package daphnis.core.population

/**
 * A mean flow along [flowAxis] that changes with the position along [normalAxis] (0 = x, 1 = y, 2 = z), by [rate] per
 * unit of length where it is uniform: v_x = γ y in Lees–Edwards boxes, v_y = −(3/2) Ω x in Hill's frame.
 */
public class MeanFlow(public val normalAxis: Int, public val flowAxis: Int, public val rate: Double)
