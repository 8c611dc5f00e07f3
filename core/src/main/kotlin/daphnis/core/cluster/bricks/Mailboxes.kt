package daphnis.core.cluster.bricks

/**
 * Messages between the bricks of one process, and their agreement, from one phase of a step to the next. Within a phase
 * one thread works for a brick: it alone posts from the brick, and it alone takes what the phase before has posted to
 * the brick. Between two phases is a barrier, and [turn] is called, so a message is written, then the barrier, then
 * read. Nothing is copied: a message refers to the arrays of its sender. What a failed step has left is dropped by
 * whoever takes it in the next, since it has the key of another step.
 */
internal class Mailboxes(private val bricks: Int) {
    /** By place of the receiver, then by place of the sender, who alone adds. */
    private var filling = boxes()
    private var filled = boxes()

    private fun boxes() = Array(bricks + 1) { Array(bricks + 1) { ArrayList<BrickMessage>(0) } }

    /** The place of a brick, or of the agreement, which is last. */
    private fun place(number: Int): Int = if (number == BrickMessage.AGREEMENT) bricks else number

    /** The post of brick [from]. */
    fun post(from: Int): Post = Post { to, message -> filling[place(to)][from].add(message) }

    /** The post of the agreement, for the one thread that works between two phases: it reaches the next of them. */
    fun postBetween(): Post = Post { to, message -> filled[place(to)][bricks].add(message) }

    /** A phase is over: what was posted in it can be taken. */
    fun turn() {
        filling = filled.also { filled = filling }
    }

    /** Brings [message] from another process to brick [to], or to the agreement, between two phases. */
    fun deliver(to: Int, message: BrickMessage) {
        filled[place(to)][place(message.from)].add(message)
    }

    /** Hands all messages to the agreement to [look]; they stay. */
    inline fun look(look: (BrickMessage) -> Unit) {
        for (box in filled[bricks]) for (k in box.indices) look(box[k])
    }

    /** Hands all messages to [number] to [receive] and removes them. */
    inline fun take(number: Int, receive: (BrickMessage) -> Unit) {
        for (box in filled[place(number)]) {
            for (k in box.indices) receive(box[k])
            box.clear()
        }
    }
}
