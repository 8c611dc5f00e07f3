package daphnis.analysis.report

/**
 * What a file in `tables/` holds.
 *
 * @property name of the file without `.csv`; a word in capitals stands for others
 * @property meaning of a row and of the columns that their names do not tell
 * @property columns with what they mean, where a line is not enough
 */
internal class ReportTable(
    val name: String,
    val meaning: String,
    val columns: List<Pair<String, String>> = emptyList(),
) {
    private val pattern = Regex(name.replace(Regex("[A-Z]+"), ".+"))

    fun matches(given: String): Boolean = pattern.matches(given)
}

/** All files that a report may write into `tables/`, from which `docs/reference/tables.md` is made. */
internal object ReportTables {
    private val streamlines = listOf(
        "slab, group" to "slab of azimuth, group of equal count in it, from 0",
        "count, mean_x, mean_y, min_x, max_x, guiding_x" to "of the group",
        "optical_depth" to
            "Σ π r²/(Δx Δy); Δx between the middles of neighbouring groups, at their mean x or guiding " +
            "centre; at the ends of a periodic patch the neighbour is the image; without the bias of 1/Δx, at most " +
            "5/(12 n) of n particles",
        "mean_e, mean_i" to "⟨e⟩, ⟨i⟩, lengths",
        "phase" to "direction of Σ e exp(iφ), unwrapped from slab to slab",
        "forced_e" to "|⟨e exp(iφ)⟩|; n random epicycles alone make it about 0.9 ⟨e²⟩^½/√n",
        "forced_e_unbiased" to "(|⟨e exp(iφ)⟩|² − its expected noise)^½; 0 where noise is more",
        "dispersion" to "around the group's mean, by number, shear subtracted, times 1 + 1/(4f) for f degrees of " +
            "freedom of the sum of three squares (Satterthwaite 1946), as the root of a mean of few is too small",
        "q" to "|d(e exp(iφ))/dX| between neighbours; streamlines cross where it reaches 1 (Borderies, Goldreich & " +
            "Tremaine 1982, Nature 299, 209)",
        "spacing" to "distance to the next streamline out",
        "…_error" to "from the scatter of the group's particles as if they were independent; empty below ten; " +
            "mean_x_error is for a given guiding_x, in that order only",
    )

    private val clusters = listOf(
        "members, mass, spanning" to "number and mass of its spheres; 1 where it spans the box",
        "x, y, z" to "centre of mass, in the box",
        "gyration_radius" to "R_g² = Σ m (|r − centre|² + (3/5) radius²)/Σ m, of discs (1/2) radius²",
        "filling_factor" to "volume of the spheres over that of a ball of radius (5/3)^½ R_g (Mukai et al. 1992, A&A " +
            "262, 315); of discs areas, 2^½ R_g",
        "vx, vy, vz" to "velocity of the centre against the flow that the boundary drives there",
        "wx, wy, wz" to "spin ω = I⁻¹ L about the centre, with the spins of rough spheres; relative to Hill's frame",
        "temperature" to "⟨c²⟩/3, of discs ⟨c²⟩/2, without the motion of the centre and the rigid rotation, over the " +
            "degrees of freedom that are left",
        "of one that spans the box" to
            "centre, R_g, filling factor and spin are empty, the temperature is around its " +
            "mean velocity",
    )

    private val moments = listOf(
        "mean" to "⟨T⟩",
        "variance" to "⟨(T − ⟨T⟩)²⟩ of the light as seen, noise of photons included",
        "excess_variance" to "that less ⟨T⟩/I, the part of the photons (Showalter & Nicholson 1990, Icarus 87, 285)",
        "skewness, kurtosis" to "⟨(T − ⟨T⟩)³⟩/σ³, ⟨(T − ⟨T⟩)⁴⟩/σ⁴ − 3, noise included",
        "random_variance" to "what as many opaque spheres of the same sizes would have at random places",
        "autocorrelation_length" to "where the covariance along the path over the excess variance falls to 1/e, on " +
            "straight lines between lags of whole footprints, up to half a track; none below a footprint",
    )

    private val general = listOf(
        ReportTable(
            "numbers",
            "each number of the report with its ±, its unit, what it is held against and the bound of that",
        ),
        ReportTable("time-series", "temperature and energies of `series.csv` over the run"),
        ReportTable("collision-rate", "collisions per particle and time over the run"),
        ReportTable("evolution", "velocity dispersions of `transport.csv` over the run"),
        ReportTable("toomre-q", "Toomre's Q over the run"),
        ReportTable("viscosity-by-orbit", "total viscosity, a mean for each orbit"),
        ReportTable(
            "profile-AXIS",
            "by bin along x (`-radial`), y (`-azimuthal`) or z (`-vertical`): count, surface density, optical depth, " +
                "filling factor, mean velocity and ⟨c_a c_b⟩ without the imposed flow, over the particles of all " +
                "states together, by number",
        ),
        ReportTable("impact-speeds", "share of all collisions per unit of ln v_n, by impact speed"),
        ReportTable("flow", "mean velocity in cells of the x-y plane"),
        ReportTable("compression", "filling factor and pressure Z of spheres that grow, beside the fluid's"),
        ReportTable("exchanged", "number of particles, and what came and left by source, over the run"),
        ReportTable(
            "size-classes",
            "count, mean radius, σ_x, σ_y, σ_z, c, by number around the mean flow and the centre of mass of all, and " +
                "H in Hill's frame, by size",
        ),
        ReportTable(
            "materials",
            "number, mean radius and partial temperature of each material; spins of rough spheres",
        ),
        ReportTable("spins-by-size", "rms spin, mean spin and both partial temperatures by size"),
        ReportTable(
            "spin-distribution",
            "densities of s = √(I/T) (ω − ⟨ω⟩) by component and modulus, and a Maxwellian",
        ),
    )

    private val rings = listOf(
        ReportTable(
            "streamlines-KEY",
            "a row for each group, sorted by x (`-x`) or by guiding centre (`-guiding-centre`)",
            streamlines,
        ),
        ReportTable(
            "waves",
            "all numbers of all modes m: 2 ⟨(q − ⟨q⟩) exp(−i k x)⟩ of surface density, v_x, v_y and temperature by " +
                "mass, k = 2π m/L; waves outward and inward are (v_x ± i (2Ω/κ) v_y)/2",
        ),
        ReportTable(
            "wave-history",
            "by radial period: rms v_x of each mode m (`rms_vx_m`), that of the coherent part, to which growth is " +
                "fitted (`coherent_vx_m`), and the strongest wavelength",
        ),
        ReportTable("wave-blocks", "rms v_x and density of each mode over blocks of five orbits"),
        ReportTable("wave-density", "Σ(x, t) over the last eight periods, over its mean"),
        ReportTable("perturbation", "surface density, dispersion and flux by phase of the perturbed sheet"),
        ReportTable("moonlet-map", "Σ/⟨Σ⟩ − 1 around the first moonlet"),
        ReportTable("moonlet-wake", "Σ/⟨Σ⟩ − 1 along the orbit of the moonlet"),
        ReportTable("wakes", "pitch angle and radial spacing of wakes, or the pitch of the central ridge"),
        ReportTable(
            "autocorrelation",
            "A = ⟨δΣ(r) δΣ(r + l)⟩/⟨Σ⟩² of the surface density (Salo 1995, Icarus 117, 287)",
        ),
        ReportTable("autocorrelation-x", "the same along x, of a thin patch"),
        ReportTable("occultation", "share T of the rays that pass, by x: last state and mean"),
        ReportTable("occultation-grid", "T and −sin B · ln T by elevation and azimuth"),
        ReportTable("occultation-wakes", "fits of elliptic and rectangular bars"),
        ReportTable("occultation-scan", "light along tracks of the last state"),
        ReportTable("occultation-scan-moments", "one row, of the footprints of all tracks and states", moments),
        ReportTable("occultation-autocorrelation", "autocorrelation of the light along the path"),
        ReportTable(
            "occultation-observed",
            "the patch along the observed lines, residuals, and each over its joint error",
        ),
        ReportTable(
            "brightness-grid",
            "T, I/F of single scattering and of all orders by elevation and azimuth of the eye, over a whole turn",
        ),
        ReportTable("brightness-elevation", "I/F over all azimuths (the tilt effect) and the asymmetry, by elevation"),
        ReportTable("brightness-phase", "I/F by phase angle, over that at the first, and by order"),
        ReportTable("brightness-observed", "the patch beside what was observed, and the residuals"),
    )

    private val fluids = listOf(
        ReportTable("mean-square-displacement", "displacements over all lags; ± where there are five blocks of time"),
        ReportTable("velocity-autocorrelation", "C(t), C(t)/C(0) and D(t), the integral up to t"),
        ReportTable(
            "pair-correlation",
            "g(r), pairs at a distance over pairs expected without correlation; theory where there is one",
        ),
        ReportTable(
            "structure-factor",
            "S(k) = |Σ exp(i k·r)|²/N, averaged over directions; theory where there is one",
        ),
        ReportTable("pair-correlation-by-KIND", "g_ab(r) of each two materials or sizes, up to three"),
        ReportTable(
            "structure-factor-by-KIND",
            "S_ab(k) = Re Σ_a exp(i k·r) Σ_b exp(−i k·r)/√(N_a N_b) of each two (Ashcroft & Langreth 1967, Phys. " +
                "Rev. 156, 685)",
        ),
        ReportTable("contact-values", "g_ab at contact of each two, beside theory"),
        ReportTable("insertion", "−ln of the probability that a sphere fits in, by diameter, beside theory"),
        ReportTable(
            "self-scattering",
            "F_s(k, t) = ⟨cos k·Δr(t)⟩, k at the peak of S(k), and α₂(t) = d ⟨Δr⁴⟩/((d + 2) ⟨Δr²⟩²) − 1 (Rahman " +
                "1964, Phys. Rev. 136, A405)",
        ),
        ReportTable(
            "intermediate-scattering",
            "F(k, t) = ⟨ρ_k(t₀ + t) ρ_k*(t₀)⟩/N, ρ_k = Σ exp(i k·r), over wave vectors near that k; at lag 0 S(k) " +
                "(Hansen & McDonald, Theory of Simple Liquids, ch. 7.4)",
        ),
        ReportTable(
            "overlap",
            "Q(t), part of the particles with Δr(t) ≤ 0.3 diameters, and χ₄ = N (⟨Q²⟩ − ⟨Q⟩²) (Lačević, Starr, " +
                "Schrøder & Glotzer 2003, J. Chem. Phys. 119, 7372)",
        ),
        ReportTable("bond-order", "densities of bond orders of spheres"),
        ReportTable(
            "velocity-spectra",
            "S_⊥, S_∥ of Σ m (v − ⟨v⟩) exp(i k·r) over those without correlation, and S(k), of the last state (van " +
                "Noije, Ernst, Brito & Orza 1997, Phys. Rev. Lett. 79, 411)",
        ),
        ReportTable("clusters", "each cluster of the last state, the largest first", clusters),
        ReportTable(
            "cluster-sizes",
            "clusters of a state in bins of sizes, 1 to 10 by themselves, then ten for each factor of ten, with ±; " +
                "and those of the last state",
        ),
        ReportTable("cluster-history", "all numbers of clusters over the run"),
    )

    /** By heading. */
    val groups: Map<String, List<ReportTable>> =
        mapOf("Every run" to general, "Rings" to rings, "Gases, fluids and solids" to fluids)

    /** The declaration of the file [name] without its ending; null where there is none. */
    fun of(name: String): ReportTable? {
        val all = groups.values.flatten()
        return all.find { it.name == name } ?: all.find { it.matches(name) }
    }
}
