package daphnis.analysis.theory

/** Compressibility p A/(N kT) of equal hard discs by area fraction ν, in the limit of many of them. */
public object HardDiscs {
    /** Area fraction up to which [henderson] is within 0.4 %, and [luding] within 0.2 %. */
    public const val MOST_FILLED: Double = 0.5

    /** Area fraction at which the fluid ends. */
    public const val FREEZING: Double = 0.7

    /** Of the fluid, by Henderson 1975, Mol. Phys. 30, 971. */
    @JvmStatic
    public fun henderson(filling: Double): Double = (1 + filling * filling / 8) / ((1 - filling) * (1 - filling))

    /** Of the fluid, by Luding 2001, Phys. Rev. E 63, 042201: Henderson's contact value less ν³/(128 (1 − ν)⁴). */
    @JvmStatic
    public fun luding(filling: Double): Double {
        val square = (1 - filling) * (1 - filling)
        return henderson(filling) - filling * filling * filling * filling / (64 * square * square)
    }
}
