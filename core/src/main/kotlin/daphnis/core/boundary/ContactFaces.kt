package daphnis.core.boundary

/** What a sphere which moves through a face can hit within the step, and where it is after the step. */
public enum class ContactFaces {
    /** Nothing: there are no images beyond the face, and the sphere stays there. */
    OPEN,

    /** Nothing within the step: there are no images. After the step the sphere comes back through the other face. */
    WRAPPING,

    /** The periodic images of the spheres on the other side, where the sphere comes back after the step. */
    PERIODIC,

    /** The face itself, which reflects the sphere when its surface arrives there. */
    WALL,
}
