package daphnis.core.step

/**
 * Thrown at an inelastic collapse: very many collisions of one sphere while time stands still. A collapse guard
 * prevents it.
 */
public class CollapseException(message: String) : RuntimeException(message)
