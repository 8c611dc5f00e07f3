package daphnis.app.describe

/** `1 sphere`, `2 spheres`. */
internal fun spheres(count: Int): String = if (count == 1) "1 sphere" else "$count spheres"

/** `1 step`, `2 steps`. */
internal fun counted(number: Long, what: String): String = if (number == 1L) "1 $what" else "$number ${what}s"
