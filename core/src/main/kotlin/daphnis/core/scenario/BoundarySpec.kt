package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.OpenPlane
import daphnis.core.input.Described
import daphnis.core.input.InputException
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.wall.Piston
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction

/**
 * The boundaries that a scenario can name; `toString` is the name, with the parameters that distinguish two of the same
 * kind.
 */
@Serializable
public sealed interface BoundarySpec {
    /** Whether it repeats along all axes of the space, with images at rest. */
    public val repeatsAtRest: Boolean get() = false

    /** Rate of a uniform shear that its images keep up, per unit of time; null without. */
    public val shearRate: Double? get() = null

    /** Whether it is the shearing sheet of Hill's frame, without ends. */
    public val isSheet: Boolean get() = false

    /** The part of its length along x by which the box becomes narrower at times. */
    public val narrowing: Double get() = 0.0

    /** Whether the box is only where spheres are put. */
    public val isOpen: Boolean get() = false

    /** Whether it gives energy to the spheres. */
    public val drives: Boolean get() = false

    /** Cycles per unit of time of faces that vibrate, each once. */
    public val frequencies: List<Double> get() = emptyList()

    /** Walls that are no faces of the box. */
    public val surfaces: List<WallSurfaceSpec> get() = emptyList()

    /** Whether spheres can come to rest between these surfaces. */
    public val mayCollapse: Boolean get() = false

    /** Position and velocity with which each face begins that impacts push, by face. */
    public val pistons: Map<Int, List<Double>> get() = emptyMap()

    /** The same where [pistons] begin as in [states]. */
    public fun withPistons(states: Map<Int, List<Double>>): BoundarySpec = this

    /**
     * The boundary conditions around [box].
     *
     * @param orbits in Hill's frame; null without a frame
     * @param check names the scenario in messages
     * @param seed by which thermal walls draw
     * @throws daphnis.core.input.InputException for values that are wrong
     */
    public fun conditions(box: Box, orbits: OrbitalFrequencies?, check: ValueCheck, seed: Long): BoundaryConditions

    /** A description for a reader: [number] writes numbers, and [speed] those with a unit of speed. */
    public fun inWords(number: DoubleFunction<String>, speed: DoubleFunction<String>): String = toString()

    /** No faces. The box only gives the space in which spheres are placed at the start. */
    @Serializable
    @SerialName("open")
    @Described("no faces; the box only says where spheres are placed")
    public class Open : BoundarySpec {
        override val isOpen: Boolean get() = true

        override fun conditions(
            box: Box,
            orbits: OrbitalFrequencies?,
            check: ValueCheck,
            seed: Long,
        ): BoundaryConditions = if (box.space.isPlane) OpenPlane else daphnis.core.boundary.Open

        override fun inWords(number: DoubleFunction<String>, speed: DoubleFunction<String>): String =
            "open: only where spheres are put"

        override fun toString(): String = "open"
    }

    @Serializable
    @SerialName("periodic")
    @Described("periodic along all axes; contacts are found through all faces")
    public class Periodic : BoundarySpec {
        override val repeatsAtRest: Boolean get() = true

        override fun conditions(
            box: Box,
            orbits: OrbitalFrequencies?,
            check: ValueCheck,
            seed: Long,
        ): BoundaryConditions = daphnis.core.boundary.Periodic(box)

        override fun toString(): String = "periodic"
    }

    /**
     * Walls across the axes named in [axes]; the other axes are periodic.
     *
     * @property faces what single walls have of their own
     * @property surfaces walls that are not faces of the box. Where a cylinder or a sphere in the box keeps the spheres
     *   from its faces, these are no walls, whatever [axes] says
     */
    @Serializable
    @SerialName("walls")
    @Described("walls across the named axes, and of other shapes; the other axes are periodic")
    public class Walls @JvmOverloads constructor(
        @Described("axes across which the box has walls; the others repeat; default `xyz`")
        public val axes: String = "xyz",
        @Described("coefficient of restitution, in [0, 1]; default 1")
        public val restitution: Double = 1.0,
        @Described("surfaces of the faces; default smooth")
        public val roughness: WallRoughnessSpec? = null,
        @Described("what single faces have of their own; default nothing")
        public val faces: WallFacesSpec? = null,
        @Described("walls that are not faces of the box; default none")
        override val surfaces: List<WallSurfaceSpec> = emptyList(),
    ) : BoundarySpec {
        override val drives: Boolean
            get() = faces?.named.orEmpty().any { it?.drives == true } || surfaces.any { it.drives }
        override val frequencies: List<Double>
            get() = faces?.named.orEmpty().mapNotNull { it?.motion?.frequency }.distinct()
        override val mayCollapse: Boolean get() = surfaces.any { (it.restitution ?: restitution) < 1 }
        override val pistons: Map<Int, List<Double>> get() = faces?.pistons.orEmpty()

        override fun withPistons(states: Map<Int, List<Double>>): BoundarySpec =
            Walls(axes, restitution, roughness, faces?.withPistons(states), surfaces)

        override fun conditions(
            box: Box,
            orbits: OrbitalFrequencies?,
            check: ValueCheck,
            seed: Long,
        ): BoundaryConditions {
            val known = (axes.isNotEmpty() || surfaces.isNotEmpty()) &&
                axes.all { it in AXES } &&
                axes.toSet().size == axes.length
            check.that("boundary.axes", axes, known) { "must name axes, such as xyz or z" }
            check.fraction("boundary.restitution", restitution)
            val named = axes.toList().filter { AXES.indexOf(it) < box.space.dimensions }
            check.that("boundary.axes", axes, named.isNotEmpty() || surfaces.isNotEmpty()) {
                "must name x, y or both, with dimensions 2"
            }
            val shapes = surfaces.mapIndexed { k, it -> it.surface("$SURFACES[$k]", check) }
            val inSpace = named.filter { !WallShapes.areEnclosing(AXES.indexOf(it), box, shapes) }.joinToString("")
            val walled = BooleanArray(AXES.length) { AXES[it] in inSpace }
            WallShapes.check(shapes, walled, box, check)
            val rough = roughness?.laws(inSpace, check) ?: emptyList()
            val own = faces?.faces(inSpace, check) ?: emptyList()
            for (face in own.indices) {
                val isRough = rough.getOrNull(face) != null
                check.must(
                    "${WallFacesSpec.KEY}.${WallFacesSpec.NAMES[face]}",
                    own[face]?.temperature == null || !isRough,
                ) {
                    "has a temperature; a thermal wall cannot be rough"
                }
                check.must(
                    "${WallFacesSpec.KEY}.${WallFacesSpec.NAMES[face]}",
                    own[face]?.motion?.isKnownAhead != false || !isRough,
                ) {
                    "is a piston, which cannot be rough"
                }
            }
            val walls = daphnis.core.boundary.Walls(box, restitution, walled, rough, own, seed, shapes)
            check.must(SURFACES, walls.volume > 0) { "leave no room in the box" }
            return walls
        }

        override fun inWords(number: DoubleFunction<String>, speed: DoubleFunction<String>): String =
            (if (axes.isEmpty()) ONLY_SURFACES else "walls across $axes") +
                ", restitution ${number.apply(restitution)}, " +
                "surfaces ${roughness?.inWords(axes, number) ?: "smooth"}" +
                faces?.inWords(number).orEmpty() + surfaces.joinToString("") { "; ${it.inWords(number)}" }

        override fun toString(): String = if (axes.isEmpty()) ONLY_SURFACES else "walls with axes $axes"
    }

    /** The paper's sheared periodic box. */
    @Serializable
    @SerialName("sheared-periodic")
    @Described(
        "the paper's box: wraps spheres after each step and changes v_x of those that crossed a y face; no " +
            "contacts through faces",
    )
    public class ShearedPeriodic(
        @Described("v_x that a sphere gets which crosses a y face, a speed")
        public val velocityJump: Double,
    ) : BoundarySpec {
        override val drives: Boolean get() = velocityJump != 0.0

        override fun conditions(
            box: Box,
            orbits: OrbitalFrequencies?,
            check: ValueCheck,
            seed: Long,
        ): BoundaryConditions {
            check.speed("boundary.velocityJump", velocityJump)
            return daphnis.core.boundary.ShearedPeriodic(box, velocityJump)
        }

        override fun inWords(number: DoubleFunction<String>, speed: DoubleFunction<String>): String =
            "$this, velocity jump ${speed.apply(velocityJump)}"

        override fun toString(): String = "sheared-periodic"
    }

    @Serializable
    @SerialName("lees-edwards")
    @Described("images slide; contacts are found through all faces")
    public class LeesEdwards(
        @Described("of the mean flow that sliding images keep up, 1/time")
        override val shearRate: Double,
    ) : BoundarySpec {
        override val drives: Boolean get() = shearRate != 0.0

        override fun conditions(
            box: Box,
            orbits: OrbitalFrequencies?,
            check: ValueCheck,
            seed: Long,
        ): BoundaryConditions = daphnis.core.boundary.LeesEdwards(box, shearRate)

        override fun inWords(number: DoubleFunction<String>, speed: DoubleFunction<String>): String =
            "$this, shear rate ${number.apply(shearRate)} per unit of time"

        override fun toString(): String = "lees-edwards"
    }

    /**
     * The shearing sheet of Hill's frame, or with [radiallyOpen] a ringlet that repeats along the orbit only.
     *
     * @property perturbation q in [0, 1) of a sheet whose images breathe
     */
    @OptIn(ExperimentalSerializationApi::class)
    @Serializable
    @SerialName("hill-sheet")
    @Described("the shearing sheet of Hill's frame, periodic along y and x, open along z; needs `frame`")
    public class HillSheet @JvmOverloads constructor(
        @Described("whether it is a ringlet with free edges; default false")
        public val radiallyOpen: Boolean = false,
        @Described("q of a sheet whose images breathe, 0 ≤ q < 1; default 0")
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val perturbation: Double = 0.0,
    ) : BoundarySpec {
        override val narrowing: Double get() = perturbation
        override val isSheet: Boolean get() = !radiallyOpen
        override val drives: Boolean get() = true

        override fun conditions(
            box: Box,
            orbits: OrbitalFrequencies?,
            check: ValueCheck,
            seed: Long,
        ): BoundaryConditions {
            val around = orbits ?: check.fail("boundary", "is a hill-sheet; it needs a frame of type hill")
            check.that(PERTURBATION, perturbation, perturbation >= 0 && perturbation < 1) {
                "must be at least 0 and less than 1; streamlines cross at 1"
            }
            check.must(PERTURBATION, perturbation == 0.0 || !radiallyOpen) {
                "is $perturbation; a ringlet (boundary.radiallyOpen) has no images along x that could breathe"
            }
            return daphnis.core.hill.HillSheet(box, around, radiallyOpen, perturbation)
        }

        override fun inWords(number: DoubleFunction<String>, speed: DoubleFunction<String>): String = when {
            radiallyOpen -> "ringlet, repeats along y"
            perturbation == 0.0 -> "shearing sheet, repeats along x and y"
            else ->
                "perturbed shearing sheet, repeats along x and y; q = ${number.apply(
                    perturbation,
                )}: once in a radial " +
                    "period it narrows to ${number.apply(1 - perturbation)} and widens to " +
                    "${number.apply(1 + perturbation)} of its length along x, and is narrowest at time 0"
        }

        override fun toString(): String = "hill-sheet"

        private companion object {
            const val PERTURBATION = "boundary.perturbation"
        }
    }

    public companion object {
        private const val AXES = "xyz"
        private const val ONLY_SURFACES = "walls of surfaces only"

        /** Names of the boundaries that drive a mean flow. */
        internal const val SHEARED: String = "lees-edwards, sheared-periodic or hill-sheet"
    }
}
