package daphnis.analysis.report

/** Keys of numbers of gases, fluids and granular matter in boxes; of rough spheres also those of rings. */
internal object BoxKeys {
    private const val NOIJE = "van Noije & Ernst 1998, Granular Matter 1, 57"
    private const val SANTOS = "Santos, Kremer & dos Santos 2011, Phys. Fluids 23, 030604"
    private const val STEINHARDT = "Steinhardt, Nelson & Ronchetti 1983, Phys. Rev. B 28, 784"

    private val box = KeyGroup(
        "A box",
        "Without Hill's frame",
        listOf(
            ReportKey(
                "filling_factor",
                "φ, volume of the spheres over that of the box; with sources an average",
                only = "no gravity that presses them against a wall, no piston",
            ),
            ReportKey("area_fraction", "area fraction ν", only = "discs"),
            ReportKey("volume", "volume, of discs area, between the walls", "length³, length²", only = "a piston"),
            ReportKey("granular_temperature", "T = ⟨c²⟩/3, of discs ⟨c²⟩/2, by mass", "length²/time²"),
            ReportKey(
                "velocity_a2",
                "fourth cumulant a₂ = (3/5) ⟨c⁴⟩/⟨c²⟩² − 1 of √m c, of discs (1/2) ⟨c⁴⟩/⟨c²⟩² − 1; 0 of Maxwellians; " +
                    "partial temperatures that differ raise it",
                whence = NOIJE,
            ),
            ReportKey(
                "compressibility",
                "Z = p V/(M T), of discs p A/(M T)",
                only = "`transport.csv`; no gravity that presses them against a wall",
            ),
            ReportKey("partial_temperature_NAME", "m ⟨c²⟩/3 of the material NAME", "energy", only = "materials"),
            ReportKey(
                "temperature_ratio_FIRST_NAME",
                "partial temperature of the first material over that of NAME, mean of the ratio at each time",
                only = "materials",
            ),
        ),
    )

    private val sources = KeyGroup(
        "Sources and sinks",
        "Runs with `sources`, from rows of `series.csv`; the source K is counted from 0",
        listOf(
            ReportKey("particles", "number N, on average"),
            ReportKey("particle_fluctuations", "⟨δN²⟩/⟨N⟩, n kT κ_T of a gas that is all in contact with a reservoir"),
            ReportKey("sourceK_rate", "what came less what left", "1/time"),
            ReportKey("sourceK_power", "energy of what came less that of what left", "energy/time"),
            ReportKey("sourceK_energy", "mean energy of a sphere", "energy", only = "brings or takes, not both"),
            ReportKey("sourceK_refused", "part that found no place", only = "brings"),
        ),
    )

    private val spins = KeyGroup(
        "Spins",
        "Rough spheres; relative to the frame in Hill's frame, where Ω more is among the stars",
        listOf(
            ReportKey("rotational_temperature", "Σ I ω²/3M, with the mean spin in it", "length²/time²; r² Ω² of rings"),
            ReportKey("rotational_over_translational", "mean of that over ⟨c²⟩/3 at the same time"),
            ReportKey("mean_spin_x", "mean spin ⟨ω_x⟩", "1/time", only = "a box"),
            ReportKey("mean_spin_y", "⟨ω_y⟩", "1/time", only = "a box"),
            ReportKey("mean_spin_z", "⟨ω_z⟩", "1/time; Ω of rings"),
            ReportKey("spin_a2", "fourth cumulant a₀₂ of √I w, w the spin around the mean", "", SANTOS, "a box"),
            ReportKey("mixed_a2", "a₁₁ = ⟨c² w²⟩/(⟨c²⟩⟨w²⟩) − 1 of both", "", SANTOS, "a box"),
        ),
    )

    private val sheared = KeyGroup(
        "A sheared box",
        "Sheared boxes with `transport.csv`; viscosities are those above. σ: mean diameter, ρ_p: density of a sphere",
        listOf(
            ReportKey("reduced_temperature", "T* = T/(γσ)²"),
            ReportKey("reduced_pressure", "p* = p/(ρ_p σ²γ²)"),
            ReportKey("reduced_shear_stress", "τ* = −P_xy/(ρ_p σ²γ²)"),
            ReportKey(
                "normal_stress_xx",
                "P_xx/p along the flow, p the mean normal stress: they add up to 3, of discs 2",
            ),
            ReportKey("normal_stress_yy", "P_yy/p across the flow"),
            ReportKey("normal_stress_zz", "P_zz/p along the vorticity", only = "spheres"),
            ReportKey("shear_stress_ratio", "−P_xy/p"),
        ),
    )

    private const val HELFAND = "Helfand 1960, Phys. Rev. 119, 1"

    private val atRest = KeyGroup(
        "A gas at rest",
        "Smooth elastic spheres in a periodic box without forces, with `transport.csv`",
        listOf(
            ReportKey("viscosity_helfand", "shear viscosity η", "mass/(length time)", HELFAND),
            ReportKey("bulk_viscosity_helfand", "bulk viscosity κ", "mass/(length time)", HELFAND),
            ReportKey(
                "conductivity_helfand",
                "heat conductivity λ/k: the flux is −(λ/k) ∇(kT)",
                "1/(length time)",
                HELFAND,
                "one size and mass",
            ),
        ),
    )

    private val fluid = KeyGroup(
        "A fluid at rest",
        "Elastic spheres or discs of one size at rest in a periodic box",
        listOf(
            ReportKey(
                "structure_factor_zero",
                "S(0⁺), n kT times the isothermal compressibility",
                only = "φ < 0.491, ν < 0.70, not placed as a lattice",
            ),
            ReportKey("contact_value", "pair correlation at contact g(σ)"),
            ReportKey(
                "chemical_potential",
                "excess chemical potential μ_ex/kT = −ln of the probability that one more sphere fits in",
                whence = "Widom 1963, J. Chem. Phys. 39, 2808",
            ),
        ),
    )

    private val order = KeyGroup(
        "Order of neighbours",
        "Periodic boxes with φ ≥ 0.45; of discs with ν ≥ 0.6",
        listOf(
            ReportKey(
                "bond_order_q4",
                "q_l = (4π/(2l + 1) Σ_m |⟨Y_lm⟩|²)^½ over the neighbours, l = 4",
                "",
                STEINHARDT,
            ),
            ReportKey("bond_order_q6", "the same, l = 6", "", STEINHARDT),
            ReportKey(
                "bond_order_average_q6",
                "q̄₆ of q_6m averaged over a sphere and its neighbours",
                whence = "Lechner & Dellago 2008, J. Chem. Phys. 129, 114707",
            ),
            ReportKey("bond_order_w6", "w₆ of Σ |q_6m|² = 1", "", STEINHARDT),
            ReportKey(
                "solid_like_share",
                "part of the spheres with q₆·q₆ > 0.7 to seven neighbours or more",
                whence = "ten Wolde, Ruiz-Montero & Frenkel 1996, J. Chem. Phys. 104, 9932",
            ),
            ReportKey("largest_solid_share", "part of the spheres in the largest cluster of these"),
            ReportKey(
                "hexatic_order_local",
                "⟨|ψ₆|⟩ of a disc, ψ₆ = ⟨exp(6iθ)⟩ over its neighbours",
                whence = "Nelson & Halperin 1979, Phys. Rev. B 19, 2457",
                only = "discs",
            ),
            ReportKey("hexatic_order", "|⟨ψ₆⟩| of all discs", only = "discs"),
        ),
    )

    private const val STAUFFER = "Stauffer & Aharony 1994, Introduction to Percolation Theory"

    private val clusters = KeyGroup(
        "Clusters",
        "Spheres that attract each other, or a ratio that was given; single spheres are clusters of one",
        listOf(
            ReportKey("cluster_count", "clusters of two spheres or more"),
            ReportKey("cluster_share", "part of the spheres in these"),
            ReportKey("largest_cluster", "spheres in the largest"),
            ReportKey("cluster_size", "mean size Σ s n/Σ n of a cluster"),
            ReportKey("cluster_size_of_sphere", "mean size Σ s² n/Σ s n of the cluster of a sphere", "", STAUFFER),
            ReportKey("cluster_spanning_share", "part of the spheres in clusters that span the box"),
            ReportKey(
                "cluster_size_slope",
                "slope τ of n(s) ∝ s^−τ, the likeliest from two members on",
                whence = "Clauset, Shalizi & Newman 2009, SIAM Rev. 51, 661; Virkar & Clauset 2014",
                only = "clusters of two sizes",
            ),
        ),
    )

    private const val EINSTEIN = "Einstein 1905, Ann. Phys. 322, 549"
    private const val AREA = "length²/time"

    private val diffusion = KeyGroup(
        "Diffusion",
        "Boxes, along periodic axes without mean flow, with states close enough together",
        listOf(
            ReportKey("self_diffusion", "D, mean of those below", AREA, EINSTEIN, "two or three axes"),
            ReportKey(
                "self_diffusion_infinite_box",
                "D∞ = D + 2.837297 kT/(6π (η + ρD) L) of an infinite box, L the edge, η of Enskog",
                AREA,
                "Yeh & Hummer 2004, J. Phys. Chem. B 108, 15873, of liquids; ρD as in a gas a particle leaves the " +
                    "flow around it (Ernst, Hauge & van Leeuwen 1970, Phys. Rev. Lett. 25, 1254)",
                "elastic gas of equal spheres in a cube, φ ≤ 0.4",
            ),
            ReportKey(
                "self_diffusion_x",
                "D_x, half the slope of ⟨(x(t₀ + t) − x(t₀))²⟩ over origins t₀",
                AREA,
                EINSTEIN,
            ),
            ReportKey("self_diffusion_y", "D_y", AREA, EINSTEIN),
            ReportKey("self_diffusion_z", "D_z", AREA, EINSTEIN),
            ReportKey(
                "self_diffusion_green_kubo",
                "D = ∫C dt/d, C(t) = ⟨v(t₀)·v(t₀ + t)⟩",
                AREA,
                "Green 1954, J. Chem. Phys. 22, 398; Kubo 1957, J. Phys. Soc. Jpn. 12, 570",
            ),
            ReportKey("velocity_correlation_slope", "C′(0)/C(0)", "1/time"),
        ),
    )

    val groups: List<KeyGroup> = listOf(box, sources, spins, sheared, atRest, fluid, order, clusters, diffusion)
}
