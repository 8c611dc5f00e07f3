package daphnis.analysis.report

import org.junit.jupiter.api.Assertions.assertEquals
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

/** Keys in `numbers.csv`, by which others read it: a key listed here never changes. */
internal object NumberKeys {
    private val BOX = listOf("filling_factor", "mean_radius", "granular_temperature", "velocity_a2")
    private val COLLISIONS = listOf("collisions_per_particle", "compressibility")
    val GAS = BOX + COLLISIONS
    private val SHEAR = listOf(
        "reduced_temperature",
        "reduced_pressure",
        "reduced_shear_stress",
        "normal_stress_xx",
        "normal_stress_yy",
        "normal_stress_zz",
        "shear_stress_ratio",
        "viscosity_translational",
        "viscosity_collisional",
        "viscosity_total",
        "shear_work_over_dissipation",
    )
    val SHEARED = GAS + SHEAR
    private val STATES = listOf(
        "optical_depth",
        "surface_density",
        "mean_radius",
        "r_omega",
        "velocity_dispersion",
        "velocity_dispersion_thermal",
        "velocity_dispersion_total",
        "sigma_x",
        "sigma_y",
        "sigma_z",
        "ellipsoid_orientation",
        "scale_height",
        "midplane_filling_factor",
    )
    private val TRANSPORT = listOf(
        "collisions_per_particle",
        "mean_impact_speed",
        "viscosity_translational",
        "viscosity_collisional",
        "viscosity_total",
        "viscosity_total_in_run_units",
        "shear_work_over_dissipation",
    )
    val RING = STATES + TRANSPORT
    private val PERTURBATION = listOf("perturbation", "surface_density_ratio")
    private val FLUXES = listOf("angular_momentum_flux", "angular_momentum_flux_translational")
    val PERTURBED = STATES.take(2) + PERTURBATION + STATES.drop(2) + TRANSPORT.take(2) + FLUXES + TRANSPORT.last()
    private val CUMULANTS = listOf("spin_a2", "mixed_a2")
    private val SPIN = listOf("rotational_temperature", "rotational_over_translational")
    private val MEAN_SPIN = listOf("mean_spin_x", "mean_spin_y", "mean_spin_z")
    val ROUGH_GAS = BOX + CUMULANTS + SPIN + MEAN_SPIN + COLLISIONS
    val ROUGH = SPIN + "mean_spin_z"
    val SELF_GRAVITY =
        listOf("viscosity_gravitational", "toomre_q", "critical_wavelength", "hill_ratio", "viscosity_of_wakes")
    val DIFFUSION = listOf("self_diffusion", "self_diffusion_x", "self_diffusion_y", "self_diffusion_z")
    val WAVES = listOf(
        "wave_wavelength",
        "wave_rms_vx",
        "wave_frequency",
        "wave_direction",
        "wave_first_wavelength",
        "wave_growth_rate",
        "wave_growth_frequency",
    )
    val HELFAND = listOf("viscosity_helfand", "bulk_viscosity_helfand", "conductivity_helfand")
    val VELOCITIES = listOf("self_diffusion_green_kubo", "velocity_correlation_slope")
    const val INSERTED: String = "chemical_potential"
    private const val INFINITE = "self_diffusion_infinite_box"
    private const val GUIDING_CENTRES = "guiding_centre_diffusion"

    val MOONLET = listOf(
        "moonlet_hill_radius",
        "propeller_separation",
        "propeller_depth",
        "moonlet_force_impacts",
        "moonlet_force_gravity",
        "moonlet_eccentricity",
        "moonlet_drift",
        "moonlet_diffusion",
        "moonlet_walk",
    )

    val SATELLITE = listOf("satellite_force", "satellite_eccentricity", "satellite_drift", "satellite_balance")

    private val FLUID = listOf("structure_factor_zero", "contact_value")
    private val ORDER = listOf(
        "bond_order_q4",
        "bond_order_q6",
        "bond_order_average_q6",
        "bond_order_w6",
        "solid_like_share",
        "largest_solid_share",
        "hexatic_order_local",
        "hexatic_order",
    )
    private val CLUSTERS = listOf(
        "cluster_count",
        "cluster_share",
        "cluster_size",
        "cluster_size_of_sphere",
        "cluster_size_slope",
        "cluster_spanning_share",
        "largest_cluster",
    )
    private val SOURCES = listOf("particles", "particle_fluctuations")
    private const val DISCS = "area_fraction"
    private const val WALLS = "wall_work_over_dissipation"
    private const val PISTON = "volume"
    private val single = listOf(INFINITE, GUIDING_CENTRES, DISCS, WALLS, PISTON, INSERTED) + HELFAND + VELOCITIES

    private val all =
        listOf(
            RING, PERTURBED, ROUGH_GAS, SELF_GRAVITY, SHEARED, MOONLET, SATELLITE, DIFFUSION, WAVES, FLUID, ORDER,
            CLUSTERS, SOURCES, single,
        ).flatten().toSet()

    /** What is declared has all keys, each once, beside those that have a name or number of the run in them. */
    fun assertDeclared() {
        assertEquals(
            all.sorted(),
            ReportKeys.all.map {
                it.key
            }.filter { key -> key.none { it.isUpperCase() } }.sorted(),
        )
    }

    /** The keys of the run in [path], in the order of the file; all of them and its tables are declared. */
    fun of(path: Path): List<String> {
        val tables = Files.list(path.resolve("tables")).use { all -> all.map { it.nameWithoutExtension }.toList() }
        assertEquals(emptyList<String>(), tables.filter { ReportTables.of(it) == null }) { "tables not declared" }
        val keys = Files.readAllLines(path.resolve("tables/numbers.csv")).drop(1).map { it.substringBefore(',') }
        assertEquals(emptyList<String>(), keys.filter { ReportKeys.of(it) == null }) { "keys not declared" }
        return keys
    }
}
