package daphnis.core.scenario

import daphnis.core.initial.Lattice
import daphnis.core.input.Described
import daphnis.core.space.Space
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
public sealed interface PlacementSpec {
    /** The file from which spheres are read, with all that is said of it; null where they are made. */
    public val file: File? get() = null

    /** Whether places are drawn and so take long to find. */
    public val isDrawn: Boolean get() = false

    /** Whether spheres are put in the order of a crystal. */
    public val isOrdered: Boolean get() = false

    /** That crystal, where it is named. */
    public val lattice: LatticeName? get() = null

    /** Share of its sites that stay empty. */
    public val vacancies: Double get() = 0.0

    /** Reduced pressure to which spheres grow, whose sizes are proportions then; null where they have their sizes. */
    public val pressure: Double? get() = null

    /** The same with what follows from the [space]. */
    public fun settled(space: Space): PlacementSpec = this

    /** Finds places for the spheres of [room]. */
    public fun place(room: SpheresToPlace): PlacedSpheres

    @Serializable
    @SerialName("random")
    @Described("random places without overlap, to a filling factor of about 0.35")
    public class Random : PlacementSpec {
        override val isDrawn: Boolean get() = true

        override fun place(room: SpheresToPlace): PlacedSpheres = PlacedSpheres(room.atRandom())
    }

    /**
     * At random, and where that is too dense smaller ones at random, which grow while they collide; see
     * [daphnis.core.compression.GrownPlacement].
     *
     * @property pressure reduced pressure P V/(N kT) to which they grow: sizes are then the proportions of radii; null
     *   for growth to the sizes
     */
    @OptIn(ExperimentalSerializationApi::class)
    @Serializable
    @SerialName("grown")
    @Described(
        "random places at any filling factor up to about 0.64, of discs at any area fraction up to 0.9, by " +
            "growth; needs a `periodic` box",
    )
    public class Grown @JvmOverloads constructor(
        @Described(
            "reduced pressure P V/(NkT) at which spheres shall be, > 1, < 1000; `sizes` are then proportions; " +
                "default none",
        )
        @EncodeDefault(EncodeDefault.Mode.NEVER) override val pressure: Double? = null,
    ) : PlacementSpec {
        override val isDrawn: Boolean get() = true

        override fun place(room: SpheresToPlace): PlacedSpheres {
            room.refuseObstacles()
            val pressure = pressure ?: return PlacedSpheres(room.grown())
            return room.grownTo(pressure)
        }
    }

    /**
     * @property lattice `fcc`, `hcp`, `bcc` or `cubic`, of discs `hexagonal` or `square`; null for the first of them
     * @property vacancies share of the sites that stay empty, in [0, 1)
     */
    @OptIn(ExperimentalSerializationApi::class)
    @Serializable
    @SerialName("lattice")
    @Described("a lattice stretched to the box, up to a filling factor of 0.6 and more")
    public class Lattice @JvmOverloads constructor(
        @Described(
            "`fcc`, `hcp` (layers lie across z), `bcc` or `cubic`, of discs `hexagonal` or `square`; default " +
                "`fcc`, of discs `hexagonal`",
        )
        @EncodeDefault(EncodeDefault.Mode.NEVER) override val lattice: LatticeName? = null,
        @Described("share of sites, drawn at random, that stay empty; default 0")
        @EncodeDefault(EncodeDefault.Mode.NEVER) override val vacancies: Double = 0.0,
    ) : PlacementSpec {
        override val isOrdered: Boolean get() = true

        override fun place(room: SpheresToPlace): PlacedSpheres {
            room.refuseObstacles()
            room.check.that("placement.vacancies", vacancies, vacancies >= 0 && vacancies < 1) {
                "must be a share of the sites, at least 0 and less than 1"
            }
            return PlacedSpheres(room.onLattice((lattice ?: densestLattice(room.space)).lattice, vacancies))
        }

        /** With its lattice, the densest where none is given. */
        override fun settled(space: Space): Lattice =
            if (lattice != null) this else Lattice(densestLattice(space), vacancies)
    }

    /**
     * Positions, velocities, radii, masses and ids from a file of any [daphnis.core.format.SnapshotFormat]; [path] is
     * relative to the scenario.
     *
     * @property time of the state, which determines the places of sliding images and of satellites; null for 0
     * @property step of the state to take from a file that holds several; the last one when left out
     * @property density mass per volume, for a file that has no masses
     * @property wrap whether spheres outside the box are put back along axes that repeat, however far they are; without
     *   it only those that the rounding of single precision put outside
     * @property overlaps what becomes of spheres that overlap
     * @property materials names of what spheres are made of: the file says which sphere is of which, by these names or
     *   by number; without them spheres have no materials
     * @property run the run directory whose state it is, when a run was started from that
     * @property clock of that run
     */
    @Serializable
    @SerialName("file")
    @Described("a state from a file")
    public data class File @JvmOverloads constructor(
        @Described("relative to the scenario; its extension says the format")
        public val path: String,
        @Described("time of the state, from which series, snapshots and `until` count; default 0")
        public val time: Double? = null,
        @Described("which of several states in the file; default the last")
        public val step: Long? = null,
        @Described("mass per volume, where the file has no masses; default 1, which a line says")
        public val density: Double? = null,
        @Described("written by a run from a state of another: its directory")
        public val run: String? = null,
        @Described("written by a run from a state of another: how that counted its time")
        public val clock: ClockSpec? = null,
        @Described(
            "whether spheres outside are put where their images in the box are, along axes that repeat; default " +
                "false",
        )
        public val wrap: Boolean = false,
        @Described(
            "what is done about overlaps: `refuse`; `shrink` or `grow` radii; `relax`, spheres are moved apart; " +
                "default `refuse`",
        )
        public val overlaps: OverlapsName = OverlapsName.REFUSE,
        @Described("names of the materials of the file, first the one with number 0; default none")
        public val materials: List<String>? = null,
    ) : PlacementSpec {
        override val file: File get() = this

        override fun place(room: SpheresToPlace): PlacedSpheres = error("spheres of a file are read")

        /** Where a state of another [run] is from, in words; null when it is from a file that a user named. */
        public val origin: String? get() = run?.let { "step ${step ?: 0} of $it, time ${time ?: 0.0}" }
    }
}

/**
 * As [daphnis.core.Clock]: [steps] fixed steps from [start] lead to the state.
 */
@Serializable
public data class ClockSpec(
    @Described("time at which that run began")
    public val start: Double,
    @Described("steps that it had taken")
    public val steps: Long,
)

/** What becomes of spheres of a file that overlap. */
@Serializable
public enum class OverlapsName {
    /** The file is refused. */
    @SerialName("refuse")
    REFUSE,

    /** All radii are multiplied by the one factor with which none overlap; masses stay. */
    @SerialName("shrink")
    SHRINK,

    /** Spheres that overlap are moved apart; radii and velocities stay. */
    @SerialName("relax")
    RELAX,

    /**
     * Radii shrink until none overlap, and then grow back while spheres collide; velocities stay. The box repeats along
     * all axes.
     */
    @SerialName("grow")
    GROW,
}

@Serializable
public enum class LatticeName(internal val lattice: Lattice) {
    @SerialName("fcc")
    FCC(Lattice.FACE_CENTRED_CUBIC),

    @SerialName("cubic")
    CUBIC(Lattice.SIMPLE_CUBIC),

    @SerialName("bcc")
    BCC(Lattice.BODY_CENTRED_CUBIC),

    @SerialName("hcp")
    HCP(Lattice.HEXAGONAL_CLOSE_PACKED),

    @SerialName("hexagonal")
    HEXAGONAL(Lattice.HEXAGONAL),

    @SerialName("square")
    SQUARE(Lattice.SQUARE),
}

/** The densest lattice in [space], which is meant where none is named. */
internal fun densestLattice(space: Space): LatticeName = if (space.isPlane) LatticeName.HEXAGONAL else LatticeName.FCC
