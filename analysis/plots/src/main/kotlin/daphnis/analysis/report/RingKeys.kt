package daphnis.analysis.report

/** Keys of numbers of rings, and those that rings share with boxes. */
internal object RingKeys {
    private const val WISDOM = "Wisdom & Tremaine 1988, AJ 95, 925"
    private const val MEASURED = "`transport.csv`"

    private val patch = KeyGroup(
        "A patch of a ring",
        "Hill's frame",
        listOf(
            ReportKey("optical_depth", "optical depth τ = Σ π r²/area"),
            ReportKey("surface_density", "Σ = Σ m/area", "mass/length²"),
            ReportKey("mean_radius", "mean radius r of the particles; of boxes too", "length"),
            ReportKey("r_omega", "r Ω, the unit of speed", "cm/s of a run, else length/time"),
            ReportKey(
                "velocity_dispersion",
                "c = (σ_x² + σ_y² + σ_z²)^½ around the mean flow by radius, in slabs",
                "r Ω",
                WISDOM,
            ),
            ReportKey(
                "velocity_dispersion_thermal",
                "⟨c²⟩^½ around the flow of near neighbours, without the motion of waves",
                "r Ω",
            ),
            ReportKey("velocity_dispersion_total", "⟨w²⟩^½ around the orbital shear, with the motion of waves", "r Ω"),
            ReportKey("sigma_x", "σ_x = ⟨c_x²⟩^½, radial", "r Ω", WISDOM),
            ReportKey("sigma_y", "σ_y, along the orbit", "r Ω"),
            ReportKey("sigma_z", "σ_z, vertical", "r Ω"),
            ReportKey(
                "ellipsoid_orientation",
                "angle of the long axis of ⟨c_a c_b⟩ in the plane, from the radial direction toward the orbit",
                "degrees",
                "Goldreich & Tremaine 1978, Icarus 34, 227",
                "axes that differ by four of their errors",
            ),
            ReportKey("scale_height", "H = ⟨(z − ⟨z⟩)²⟩^½", "r"),
            ReportKey(
                "midplane_filling_factor",
                "volume of spheres in a slab around the mean height, a fifth of the smallest radius thick, over its own",
            ),
            ReportKey("guiding_centre_diffusion", "self-diffusion D_X of guiding centres", "r² Ω"),
        ),
    )

    private val collisions = KeyGroup(
        "Collisions and stresses",
        "Runs with $MEASURED",
        listOf(
            ReportKey("collisions_per_particle", "2 × collisions/particles/time", "1/orbit; 1/time of a box"),
            ReportKey(
                "mean_impact_speed",
                "mean normal component before a collision",
                "as `r_omega`",
                only = "Hill's frame",
            ),
            ReportKey(
                "viscosity_translational",
                "ν = ⟨w_x w_y⟩/|γ|, kinematic viscosity by the motion of particles; γ = −(3/2) Ω around a point mass",
                "r² Ω; length²/time of a box",
                WISDOM,
                "shear",
            ),
            ReportKey(
                "viscosity_collisional",
                "ν = Σ Δp_y δ_x/(M T |γ|) over the collisions of a time T; Δp is given to the sphere that δ points to",
                "the same",
                "Wisdom & Tremaine 1988; Araki & Tremaine 1986, Icarus 65, 83",
                "shear",
            ),
            ReportKey(
                "viscosity_gravitational",
                "ν = −½ Σ_ij F_y,ij (x_j − x_i)/(M |γ|) over all pairs that attract",
                "r² Ω",
                "Daisaka, Tanaka & Ida 2001, Icarus 154, 296",
                "self-gravity",
            ),
            ReportKey("viscosity_total", "sum of the viscosities", "r² Ω; length²/time of a box", only = "shear"),
            ReportKey(
                "viscosity_total_in_run_units",
                "the same in the run's units",
                "length²/time",
                only = "Hill's frame",
            ),
            ReportKey(
                "shear_work_over_dissipation",
                "γ² ν over dissipation per mass, of a perturbed sheet the work of the images over whole periods; " +
                    "1 in a steady state",
                only = "shear",
            ),
            ReportKey(
                "wall_work_over_dissipation",
                "work of walls over dissipation; 1 in a steady state",
                only = "walls that move or are thermal",
            ),
        ),
    )

    private val perturbed = KeyGroup(
        "A perturbed sheet",
        "Hill's frame with `boundary.perturbation` > 0; the fluxes with $MEASURED",
        listOf(
            ReportKey("perturbation", "q of the streamlines, q = a de/da"),
            ReportKey("surface_density_ratio", "largest over least surface density, (1 + q)/(1 − q)"),
            ReportKey(
                "angular_momentum_flux",
                "mean over periods of P_xy integrated over the height; negative inward",
                "Σ r² Ω²",
                "Borderies, Goldreich & Tremaine 1983, Icarus 55, 124",
            ),
            ReportKey("angular_momentum_flux_translational", "its part that particles carry by moving", "Σ r² Ω²"),
        ),
    )

    private val gravity = KeyGroup(
        "Self-gravity",
        "Hill's frame with self-gravity",
        listOf(
            ReportKey("toomre_q", "Q = σ_x κ/(3.36 G Σ)", whence = "Toomre 1964, ApJ 139, 1217"),
            ReportKey("critical_wavelength", "4π² G Σ/κ²", "length", "Toomre 1964"),
            ReportKey("hill_ratio", "r_h, Hill radius of two mean particles over the distance of centres in contact"),
            ReportKey(
                "viscosity_of_wakes",
                "26 r_h⁵ G² Σ²/Ω³, to hold `viscosity_total` against where there are wakes, r_h ≥ 0.7",
                "r² Ω",
                "Daisaka, Tanaka & Ida 2001",
                MEASURED,
            ),
        ),
    )

    private val waves = KeyGroup(
        "Waves",
        "Hill's frame with `modes.csv`",
        listOf(
            ReportKey(
                "wave_wavelength",
                "wavelength of the mode with the strongest v_x in the averaged time",
                "length",
            ),
            ReportKey("wave_rms_vx", "its rms v_x, momentum density over the mean surface density", "r Ω"),
            ReportKey("wave_frequency", "its frequency; none of a harmonic", "Ω"),
            ReportKey("wave_direction", "part of its power outward less that inward: 1, 0 standing, −1"),
            ReportKey("wave_first_wavelength", "wavelength of the mode that is strongest while waves grow", "length"),
            ReportKey(
                "wave_growth_rate",
                "its growth rate in that time, or over the whole run where nothing grows",
                "1/orbit",
            ),
            ReportKey("wave_growth_frequency", "its frequency in that time", "Ω"),
        ),
    )

    private val moonlets = KeyGroup(
        "Moonlets and satellites",
        "Hill's frame with `bodies`, or satellites that feel the ring; but for the first three rows with `bodies.csv`",
        listOf(
            ReportKey("moonlet_hill_radius", "r_H = (G m/3Ω²)^⅓ of the first body", "length"),
            ReportKey(
                "propeller_separation",
                "radial distance of the two gaps of its propeller: mean place of Σ/⟨Σ⟩ − 1 < 0, weighted by its " +
                    "third power, 2–8 r_H downstream and within 4 r_H of its orbit",
                "r_H",
                "Spahn & Sremčević 2000, A&A 358, 368; Seiß et al. 2005, GRL 32, L11205",
                "a tenth of the ring missing in two gaps, not one lane",
            ),
            ReportKey("propeller_depth", "part of the surface density missing in them"),
            ReportKey(
                "moonlet_force_impacts",
                "mean force along its orbit by impacts; times the distance from the planet, torque",
                "mass length/time²",
            ),
            ReportKey("moonlet_force_gravity", "the same by all else, which is gravity", "mass length/time²"),
            ReportKey("moonlet_eccentricity", "mean of its a·e", "length"),
            ReportKey("moonlet_drift", "drift of a of all bodies", "length/orbit", only = "four orbits"),
            ReportKey(
                "moonlet_diffusion",
                "D = Σ (ΔX − v Δt)²/(2 Σ Δt) · n/(n − 1) of their a around the drift, over n times of two orbits, or " +
                    "4, 8, … until one does not remember the other",
                "length²/orbit",
                "Rein & Papaloizou 2010, A&A 524, A22",
                "four orbits",
            ),
            ReportKey("moonlet_walk", "√(2Dt) for 100 orbits", "length", only = "four orbits"),
            ReportKey(
                "satellite_force",
                "mean force of the ring along the orbit of the first satellite",
                "mass length/time²",
            ),
            ReportKey("satellite_eccentricity", "mean of its a·e", "length"),
            ReportKey("satellite_drift", "drift of its a", "length/orbit", only = "four orbits"),
            ReportKey(
                "satellite_balance",
                "Σ m X that the ring lost over that which satellites took up, from the first state to the last; 1",
                only = "rows at these states",
            ),
        ),
    )

    val groups: List<KeyGroup> = listOf(patch, collisions, perturbed, gravity, waves, moonlets)
}
