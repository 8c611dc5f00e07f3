package daphnis.cluster.hosts

import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class HostPortTest {
    @Test
    fun `names and addresses are read with their ports`() {
        assertEquals(HostPort("n001", 25520), HostPort.parse("n001:25520", "join"))
        assertEquals(HostPort("10.0.0.7", 1), HostPort.parse(" 10.0.0.7:1 ", "join"))
        assertEquals(HostPort("127.0.0.1", 9), HostPort.parse("localhost:9", "join"))
        assertEquals(HostPort("::1", 65535), HostPort.parse("[::1]:65535", "join"))
        assertEquals(HostPort("fe80::1", 7), HostPort.parse("[fe80::1]", "join", 7))
        assertEquals(HostPort("login.cluster_2", 7), HostPort.parse("login.cluster_2", "join", 7))
    }

    @Test
    fun `what is written is read`() {
        for (one in listOf(HostPort("a", 1), HostPort("::1", 2), HostPort("127.0.0.1", 3))) {
            assertEquals(one, HostPort.parse("$one", "join"))
        }
        assertEquals(listOf(HostPort("a", 1), HostPort("::1", 2)), HostPort.parseList("a:1,[::1]:2", "join"))
    }

    @Test
    fun `what is wrong is named`() {
        for ((text, what) in mapOf(
            "n1" to "a port is needed",
            "n1:" to "the port must be in 1..65535",
            "n1:0" to "the port must be",
            "n1:65536" to "the port must be",
            "n1:x" to "the port must be",
            "[::1]25520" to "the port must be",
            "::1" to "goes in brackets",
            "fe80::1:25520" to "goes in brackets",
            "[::1:25520" to "the bracket ] is missing",
            "[]:1" to "no name or address",
            ":25520" to "no name or address",
            "" to "no name or address",
            "a b:1" to "no name or address",
            "http://n1:1" to "goes in brackets",
        )) {
            val e = assertThrows(InputException::class.java, { HostPort.parse(text, "join") }, text)
            assertTrue("'$text'" in e.message!! && what in e.message!!) { e.message }
        }
        assertThrows(InputException::class.java) { HostPort.parseList("a:1,", "join") }
    }
}
