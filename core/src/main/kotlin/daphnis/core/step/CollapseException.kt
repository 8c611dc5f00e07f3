package daphnis.core.step

/** Inelastic collapse: very many collisions of one sphere in no time. A collapse guard would have ended it. */
public class CollapseException(message: String) : RuntimeException(message)
