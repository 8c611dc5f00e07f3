package daphnis.analysis.report

/**
 * What the report puts beside a number of its own, where everything that decides it is the same.
 *
 * @property within where it holds; empty for everywhere
 * @property bound of the difference that is still within
 */
internal class KnownNumber(
    val state: String,
    val numbers: String,
    val source: String,
    val within: String,
    val bound: String,
) {
    companion object {
        private const val NOIJE = "van Noije & Ernst 1998, Granular Matter 1, 57"

        /** What [References], [ElasticReferences] and [CoolingReferences] give, in words for readers. */
        val all: List<KnownNumber> = listOf(
            KnownNumber(
                "steady ring patch of equal spheres, r Ω = 0.01948 cm/s",
                "dispersions, H, filling factor, rate, viscosities",
                "an independent event-driven code",
                "τ = 0.1, 0.5, 1, 2",
                "3 %, filling factor 5 %, viscosities 6 %",
            ),
            KnownNumber(
                "sheared gas",
                "T*, p*, τ*",
                "the same",
                "ε = 0.8, 0.9, 0.95, φ = 0.01, 0.1, 0.3",
                "3 %, p* and τ* 4 %",
            ),
            KnownNumber(
                "elastic fluid",
                "Z, collision rate",
                "Kolafa, Labík & Malijevský 2004, Phys. Chem. Chem. Phys. 6, 2335, less what N spheres lack",
                "φ ≤ 0.491",
                "3·10⁻⁵, and 0.3 of what N lack",
            ),
            KnownNumber("the same", "η, κ, λ", "Enskog, Chapman & Cowling 1970", "φ ≤ 0.4", "10 %, κ 30 %"),
            KnownNumber(
                "crystal placed as fcc",
                "Z, collision rate",
                "Speedy 1998, J. Phys.: Condens. Matter 10, 4387, times 1 − 1/N",
                "φ ≥ 0.543",
                "0.1 %",
            ),
            KnownNumber(
                "elastic spheres of several sizes or masses",
                "Z, rate (up to 64 kinds)",
                "Boublík 1970; Mansoori et al. 1971, J. Chem. Phys. 54, 1523",
                "φ ≤ 0.491",
                "0.5 %, and 0.9 Z/N",
            ),
            KnownNumber(
                "elastic spheres, discs",
                "μ_ex/kT",
                "Carnahan & Starling 1969, J. Chem. Phys. 51, 635; Henderson 1975, Mol. Phys. 30, 971",
                "φ ≤ 0.491, ν ≤ 0.5",
                "0.5 %, and 3/N",
            ),
            KnownNumber("the same", "S(0⁺), g(σ)", "the same", "φ ≤ 0.45, ν ≤ 0.5", "3 %, 2 %"),
            KnownNumber(
                "equal smooth elastic spheres, discs",
                "C′(0)/C(0)",
                "−2ν/d, ν of the same run",
                "",
                "1 %, and three ± of ν",
            ),
            KnownNumber(
                "elastic discs",
                "Z, collision rate",
                "Luding 2001, Phys. Rev. E 63, 042201",
                "ν ≤ 0.65",
                "0.6 %, and 3 Z/N",
            ),
            KnownNumber(
                "spheres that cool",
                "a₂; Haff's law, with the rate of Garzó & Dufty 1999, Phys. Rev. E 59, 5895, up to φ = 0.4",
                NOIJE,
                "ε ≥ 0.7",
                "0.005",
            ),
            KnownNumber(
                "spheres or discs that are sheared",
                "P_ab/p",
                "Grad's moments of Boltzmann's equation, Santos, Garzó & Dufty 2004, Phys. Rev. E 69, 061303",
                "ε ≥ 0.8, φ ≤ 0.011",
                "0.03",
            ),
            KnownNumber("spheres that white noise heats", "T, a₂", NOIJE, "ε ≥ 0.6", "5 %, 0.005"),
        )
    }
}
