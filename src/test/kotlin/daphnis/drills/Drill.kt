package daphnis.drills

/** What is tried on purpose to break daphnis, as often as asked for and the same way for the same seed. */
internal interface Drill {
    val name: String

    /** One line for the list of drills. */
    val what: String

    /** How many cases the long form has. */
    val cases: Int

    /** Tries [cases] cases drawn from [seed]; each is told to [say] in a line. */
    fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally
}

/**
 * What a drill came to.
 *
 * @property tried number of times something was done to it
 * @property lost what was lost, wrong or said badly, a line each; empty when all is well
 * @property notes what is worth knowing beside, a line each
 */
internal class Tally(val tried: Int, val lost: List<String>, val notes: List<String> = emptyList())
