package daphnis.core.force

import daphnis.core.force.mesh.MeshPoints
import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.population.Population
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * Gravity between the particles.
 *
 * @property openingAngle a node of a tree is taken as one mass when its size is below this times its distance
 * @property softening length ε in 1/(r² + ε²); 0 with modes
 * @property images the range of a tree around each particle is [images] + ½ of the shortest periodic edge
 * @property constant G in the scenario's units; from its units when left out
 * @property spacing between points of a mesh; about one point in the plane per sphere when left out
 * @property modes how many radial waves, with [GravityMethod.RADIAL_MODES] alone
 */
@Serializable
@SerialName("self-gravity")
@Described("gravity among all spheres")
public class SelfGravitySpec @JvmOverloads constructor(
    @Described("of the tree, in [0, 1]; default 0.5")
    public val openingAngle: Double = 0.5,
    @Described("ε in 1/(r² + ε²), a length; tree and mesh; default 0")
    public val softening: Double = 0.0,
    @Described(
        "of the tree, 0 to 60: it reaches `images` + ½ of the shortest periodic edge around each sphere; default " +
            "1",
    )
    public val images: Int = 1,
    @Described("G in the scenario's units; default from `units.lengthInMetres`")
    override val constant: Double? = null,
    @Described(
        "`tree`: any box, up to a range; `mesh`: a box that repeats along x and y and is open along z, with all " +
            "of its images, quicker; `radial-modes`: radially alone, as if all were the same along the orbit; " +
            "default `tree`",
    )
    public val method: GravityMethod = GravityMethod.TREE,
    @Described(
        "between points of the mesh, a length, taken as at least 1/42 of the height of the highest sphere and at " +
            "most an eighth of an edge; default about one point in the plane per sphere",
    )
    public val spacing: Double? = null,
    @Described("M of the waves L_x, L_x/2, … L_x/M of `radial-modes`, which needs it")
    public val modes: Int? = null,
) : ForceSpec {
    override val isAmongAll: Boolean get() = true

    /** Waves along x do not see two spheres. */
    override val gathers: Boolean get() = method != GravityMethod.RADIAL_MODES

    override fun force(place: ForcePlace): Force {
        val check = place.check
        val key = place.key
        check.that("$key.openingAngle", openingAngle, openingAngle >= 0 && openingAngle <= 1) { "must be in [0, 1]" }
        check.atLeast0("$key.softening", softening)
        check.that("$key.images", images, images in 0..SelfGravity.MOST_IMAGES) {
            "must be in 0..${SelfGravity.MOST_IMAGES}"
        }
        refuseKeysOfOthers(place)
        val g = place.constant(constant)
        return when (method) {
            GravityMethod.TREE -> tree(place, g)
            GravityMethod.MESH -> mesh(place, g)
            GravityMethod.RADIAL_MODES -> radial(place, g)
        }
    }

    private fun tree(place: ForcePlace, g: Double) = SelfGravity(place.boundary, g, openingAngle, softening, images)

    private fun mesh(place: ForcePlace, g: Double): MeshGravity {
        val boundary = place.boundary
        place.check.must("${place.key}.method", MeshGravity.fits(boundary)) {
            "is mesh; it needs a box that repeats along x and y, slides along y if at all, and is open along z"
        }
        val spacing = spacing ?: return MeshGravity(boundary, g, softening)
        place.check.positive("${place.key}.spacing", spacing)
        val points = boundary.box.length(0) / spacing * (boundary.box.length(1) / spacing)
        place.check.that("${place.key}.spacing", spacing, points <= MOST_IN_PLANE) {
            "makes more than ${MOST_IN_PLANE.toInt()} points in a plane; take a greater one"
        }
        return MeshGravity(boundary, g, softening, spacing)
    }

    private fun radial(place: ForcePlace, g: Double): RadialGravity {
        val key = place.key
        place.check.must("$key.method", RadialGravity.fits(place.boundary)) {
            "is radial-modes; it needs a box that repeats along x and has a length along y"
        }
        val modes = modes ?: place.check.fail("$key.modes", "is missing; radial-modes needs it")
        place.check.that("$key.modes", modes, modes in 1..RadialGravity.MOST_MODES) {
            "must be in 1..${RadialGravity.MOST_MODES}"
        }
        place.check.must("$key.softening", softening == 0.0) { "goes with the methods tree and mesh" }
        return RadialGravity(place.boundary, g, modes)
    }

    private fun refuseKeysOfOthers(place: ForcePlace) {
        val usual = SelfGravitySpec()
        fun only(name: String, isUsual: Boolean, method: GravityMethod, called: String) =
            place.check.must("${place.key}.$name", isUsual || this.method == method) { "goes with the method $called" }
        only("openingAngle", openingAngle == usual.openingAngle, GravityMethod.TREE, "tree")
        only("images", images == usual.images, GravityMethod.TREE, "tree")
        only("spacing", spacing == null, GravityMethod.MESH, "mesh")
        only("modes", modes == null, GravityMethod.RADIAL_MODES, "radial-modes")
    }

    /** Clouds of a mesh that reach beyond the patch make each sphere pull on each of many images by itself. */
    override fun checkStart(place: ForcePlace, population: Population, duration: Double) {
        if (method != GravityMethod.MESH || population.size == 0) return
        val box = place.boundary.box
        val lowest = population.z.min()
        val highest = population.z.max()
        fun points(softening: Double) = MeshPoints.choose(
            population.size,
            box.length(0),
            box.length(1),
            lowest,
            highest,
            spacing ?: 0.0,
            softening,
        )
        val edge = minOf(box.length(0), box.length(1))
        place.check.must("${place.key}.method", points(0.0).reach <= edge) {
            "is mesh, for flat patches; spheres from $lowest to $highest make it coarser than the patch is wide; " +
                "take the tree"
        }
        val chosen = points(softening)
        place.check.that("${place.key}.softening", softening, chosen.reach <= edge) {
            "makes the mesh coarser than the patch is wide; take the tree"
        }
        val size = chosen.nx.toDouble() * chosen.ny * chosen.nz
        place.check.must("${place.key}.spacing", size <= MOST_POINTS) {
            "makes a mesh of $size points, and there can be $MOST_POINTS; give a greater one"
        }
    }

    override fun inWords(place: ForcePlace, population: Population, say: Quantities): String = when (method) {
        GravityMethod.TREE ->
            "self-gravity, opening angle ${number(openingAngle)}, softening ${say.length(softening)}, " +
                "reaches ${say.length(tree(place, 0.0).range)}"
        GravityMethod.MESH -> {
            val apart = MeshGravity(place.boundary, 0.0, softening, spacing ?: 0.0).spacingFor(population)
            "self-gravity by a mesh, points ${say.length(apart)} apart, " +
                "softening ${say.length(softening)}, with all images"
        }
        GravityMethod.RADIAL_MODES ->
            "self-gravity along x alone, $modes waves down to ${say.length(place.boundary.box.length(0) / modes!!)}"
    }

    override fun fastestPull(place: ForcePlace, population: Population): Pull? {
        if (!gathers) return null
        val g = constant ?: place.units.gravitationalConstant ?: return null
        val fastest = place.particles(population).maxOfOrNull {
            orbitalRate(2 * g * population.mass[it], 2 * population.radius[it], softening)
        }
        return fastest?.let { Pull(it, "two spheres in contact") }
    }

    /** A walk through the tree as runs of some thousand spheres take it; a mesh. */
    override fun seconds(spheres: Int): Double = when (method) {
        GravityMethod.TREE -> {
            val boxes = (2.0 * images + 1) * (2.0 * images + 1)
            val angle = maxOf(openingAngle, LEAST_ANGLE)
            minOf(WALK_SECONDS * ln(spheres * boxes + 1) / (angle * angle), PAIR_SECONDS * spheres * boxes)
        }
        GravityMethod.MESH -> MESH_SECONDS
        GravityMethod.RADIAL_MODES -> WAVES_SECONDS
    }
}

/** Of the orbit at [distance] around a mass of the given G times mass, with [softening]. */
internal fun orbitalRate(strength: Double, distance: Double, softening: Double): Double {
    val square = distance * distance + softening * softening
    return sqrt(strength / (square * sqrt(square)))
}

/** In a plane of a mesh: some 0.3 GB in eight planes. */
private const val MOST_IN_PLANE = 4e6

/** Of a mesh, 0.3 GB. */
private const val MOST_POINTS = 40_000_000
private const val WALK_SECONDS = 0.3e-6
private const val PAIR_SECONDS = 5e-9
private const val MESH_SECONDS = 1.5e-6
private const val WAVES_SECONDS = 0.04e-6
private const val LEAST_ANGLE = 0.05
