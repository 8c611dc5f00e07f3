package daphnis.analysis.theory

import kotlin.math.PI

/** Compressibility p V/(N kT) of equal hard spheres by filling factor φ, in the limit of many of them. */
public object HardSpheres {
    /** Filling factor at which the fluid freezes. */
    public const val FREEZING: Double = 0.491

    /** Filling factor above which the crystal is stable. */
    public const val MELTING: Double = 0.543

    /** Filling factor of the closest packing, π/√18. */
    public const val CLOSEST_PACKING: Double = 0.740480489693061

    /** Relative accuracy of [carnahanStarling], [kolafa] and [kolafaLabikMalijevsky] up to [FREEZING]. */
    public const val CARNAHAN_STARLING_ACCURACY: Double = 3e-3
    public const val KOLAFA_ACCURACY: Double = 8e-4
    public const val KOLAFA_LABIK_MALIJEVSKY_ACCURACY: Double = 3e-5

    /** Relative accuracy of [speedy] from [MELTING] on. */
    public const val SPEEDY_ACCURACY: Double = 1e-3

    /** Powers of φ/(1 − φ), and what they are multiplied by. */
    private val POWERS = intArrayOf(0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 14, 22)
    private val FACTORS = doubleArrayOf(
        1.0, 4.0, 6.0, 2.3647684, -0.8698551, 1.1062803, -1.1014221, 0.66605866, -0.03633431, -0.20965164, 0.10555569,
        -0.0087238,
    )

    /** Of the fluid, by Carnahan & Starling 1969, J. Chem. Phys. 51, 635. */
    @JvmStatic
    public fun carnahanStarling(filling: Double): Double = 1 + 4 * filling * carnahanStarlingContact(filling)

    /** g(σ) of the fluid that goes with [carnahanStarling]. */
    @JvmStatic
    public fun carnahanStarlingContact(filling: Double): Double {
        val free = 1 - filling
        return (1 - filling / 2) / (free * free * free)
    }

    /** μ_ex/kT of the fluid that goes with [carnahanStarling]: (8φ − 9φ² + 3φ³)/(1 − φ)³. */
    @JvmStatic
    public fun carnahanStarlingChemicalPotential(filling: Double): Double {
        val free = 1 - filling
        return filling * (8 + filling * (3 * filling - 9)) / (free * free * free)
    }

    /** S(0⁺) = d(nkT)/dp of the fluid that goes with [carnahanStarling]. */
    @JvmStatic
    public fun carnahanStarlingLongWaveLimit(filling: Double): Double {
        val free = (1 - filling) * (1 - filling)
        val two = 1 + 2 * filling
        return free * free / (two * two + filling * filling * filling * (filling - 4))
    }

    /** Of the fluid, by Kolafa (in Boublík & Nezbeda 1986, Collect. Czech. Chem. Commun. 51, 2301, eq. 4.46). */
    @JvmStatic
    public fun kolafa(filling: Double): Double {
        val free = 1 - filling
        val square = filling * filling
        return (1 + filling + square - 2.0 / 3 * square * filling * (1 + filling)) / (free * free * free)
    }

    /**
     * Of the fluid, stable or not, up to φ = 0.54, by Kolafa, Labík & Malijevský 2004, Phys. Chem. Chem. Phys. 6, 2335.
     */
    @JvmStatic
    public fun kolafaLabikMalijevsky(filling: Double): Double = series(filling / (1 - filling), 0)

    /**
     * What [kolafaLabikMalijevsky] becomes in a periodic box of [count] spheres, to first order in 1/[count]: Z − S(0)
     * n (2 Z′ + n Z″)/2N, with ′ the derivative by the density n and S(0) = 1/(Z + n Z′) (Lebowitz & Percus 1961, Phys.
     * Rev. 122, 1675). The temperature is that of N − 1 free spheres, ⟨c²⟩/3 without bias from their number.
     */
    @JvmStatic
    public fun kolafaLabikMalijevsky(filling: Double, count: Int): Double {
        val x = filling / (1 - filling)
        val stretch = 1 + x // d ln x/d ln φ = 1/(1 − φ)
        val z = series(x, 0)
        val first = stretch * series(x, 1)
        // φ² d²Z/dφ² = (x²Z″)(1 + x)² + 2 x² (1 + x) Z′, both by x.
        val second = stretch * stretch * series(x, 2) + 2 * x * stretch * series(x, 1)
        return z - (2 * first + second) / (z + first) / (2 * count)
    }

    /** x^[order] times the derivative of that [order]. */
    private fun series(x: Double, order: Int): Double {
        var sum = 0.0
        for (k in POWERS.indices) {
            var term = FACTORS[k]
            for (d in 0 until order) term *= POWERS[k] - d
            repeat(POWERS[k]) { term *= x }
            sum += term
        }
        return sum
    }

    /** Of the face-centred cubic crystal from [MELTING] on, by Speedy 1998, J. Phys.: Condens. Matter 10, 4387. */
    @JvmStatic
    public fun speedy(filling: Double): Double {
        val packed = filling / CLOSEST_PACKING
        return 3 / (1 - packed) - 0.5921 * (packed - 0.7072) / (packed - 0.601)
    }

    /**
     * Filling factor of spheres of one [diameter], [density] of them in a unit of volume.
     */
    @JvmStatic
    public fun filling(density: Double, diameter: Double): Double = PI / 6 * density * diameter * diameter * diameter
}
