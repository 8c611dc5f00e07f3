package daphnis.app.describe

/** `1 sphere`, `2 spheres`. */
internal fun spheres(count: Int): String = if (count == 1) "1 sphere" else "$count spheres"
