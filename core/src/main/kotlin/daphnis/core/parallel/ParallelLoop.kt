package daphnis.core.parallel

import java.util.concurrent.atomic.AtomicInteger

/** Which worker does which part of a loop: the three strategies of Lewis & Massingill. */
public enum class LoopStrategy {
    /** Worker w takes pieces w, w + T, w + 2T, …: balanced even if the work grows along the loop. */
    ROUND_ROBIN,

    /** Worker w takes the w-th of T consecutive parts: neighbours in memory stay with one worker. */
    CHUNKS,

    /** A free worker takes the next piece: balanced for any work, at the cost of one atomic addition per piece. */
    DYNAMIC,
}

/** A loop on the threads of [handler] by one of the strategies. Allocates nothing. */
public class ParallelLoop(private val handler: ThreadHandler, public val strategy: LoopStrategy) :
    RangeLoop,
    WorkerTask {
    override val workers: Int get() = handler.threads

    // The loop in progress; written before the handler runs it, read by its workers.
    private var size = 0
    private var grain = 1
    private var body: RangeBody? = null
    private val next = AtomicInteger()

    override fun run(size: Int, grain: Int, body: RangeBody) {
        if (size <= 0) return
        if (size <= grain || workers == 1) {
            body.run(0, 0, size)
            return
        }
        this.size = size
        this.grain = grain
        this.body = body
        next.set(0)
        try {
            handler.run(this)
        } finally {
            this.body = null
        }
    }

    override fun work(worker: Int) {
        val body = body!!
        when (strategy) {
            LoopStrategy.ROUND_ROBIN -> {
                var from = worker.toLong() * grain
                while (from < size) {
                    body.run(worker, from.toInt(), minOf(from + grain, size.toLong()).toInt())
                    from += workers.toLong() * grain
                }
            }
            LoopStrategy.CHUNKS -> {
                val from = (size.toLong() * worker / workers).toInt()
                val to = (size.toLong() * (worker + 1) / workers).toInt()
                if (from < to) body.run(worker, from, to)
            }
            LoopStrategy.DYNAMIC -> {
                val pieces = (size - 1) / grain + 1
                while (true) {
                    val piece = next.getAndIncrement()
                    if (piece >= pieces) return
                    val from = piece * grain
                    body.run(worker, from, minOf(from.toLong() + grain, size.toLong()).toInt())
                }
            }
        }
    }
}
