package daphnis.cluster

import daphnis.core.cluster.Mail
import daphnis.core.cluster.NodeWork
import java.nio.ByteBuffer

/** Work that sends the leader's messages once around all nodes and back to the leader. */
internal object Echo : NodeWork {
    override fun work(mail: Mail, threads: Int) {
        while (true) {
            val message = mail.receive(if (mail.rank == 0) Mail.LEADER else mail.rank - 1)
            mail.send(if (mail.rank == mail.size - 1) Mail.LEADER else mail.rank + 1, message)
        }
    }

    /** Sends [body] around and checks that it has come back. */
    fun around(mail: Mail, body: ByteArray) {
        mail.send(0, ByteBuffer.wrap(body))
        val back = mail.receive(mail.size - 1)
        check(back == ByteBuffer.wrap(body)) { "${back.remaining()} other bytes than the ${body.size} sent came back" }
    }
}
