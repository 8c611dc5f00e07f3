package daphnis.actors.coroutine

import daphnis.actors.region.Answers
import daphnis.actors.region.Region
import daphnis.actors.region.RegionHost
import daphnis.actors.region.Share
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.CoroutineExceptionHandler
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.ExecutorCoroutineDispatcher
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.cancel
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.launch
import java.util.concurrent.ExecutorService

/**
 * The regions of an engine as coroutines on [dispatcher], each a loop over a channel of shares. Only its coroutine
 * touches a region's state while it works on a share. What happens before a send on a channel is seen after the receive that gets it.
 */
internal class CoroutineRegions(dispatcher: CoroutineDispatcher, regions: List<Region>, answers: Answers) : RegionHost {
    // How a coroutine ends is told by its completion; nothing else has to be told.
    private val scope = CoroutineScope(SupervisorJob() + dispatcher + CoroutineExceptionHandler { _, _ -> })

    /** One share at most: a region has answered the last before it gets the next. */
    private val mailboxes = List(regions.size) { Channel<Share>(1) }

    init {
        try {
            for (region in regions) {
                scope.launch { for (share in mailboxes[region.number]) region.serve(share, answers) }
                    .invokeOnCompletion { answers.leave(region.number) }
            }
        } catch (e: Throwable) {
            stop()
            throw e
        }
    }

    override val name: String get() = "the dispatcher"

    /** An executor that was told to end at once drops coroutines silently. */
    override val hasEnded: Boolean get() = executor?.isTerminated == true

    private val executor = (dispatcher as? ExecutorCoroutineDispatcher)?.executor as? ExecutorService

    override fun send(region: Int, share: Share) {
        check(mailboxes[region].trySend(share).isSuccess) { "region $region takes no share" }
    }

    override fun stop() {
        for (mailbox in mailboxes) mailbox.close()
        scope.cancel()
    }
}
