package daphnis.cluster.hosts

import daphnis.core.input.InputException

/**
 * Where a process of a cluster is reached.
 *
 * @property host name or address; an address of IPv6 without brackets
 * @property port 1 until 65535, or 0 for any that is free
 */
public data class HostPort(val host: String, val port: Int) {
    /** [host] as in a URI: an address of IPv6 in brackets. */
    internal val uriHost: String get() = if (':' in host) "[$host]" else host

    override fun toString(): String = "$uriHost:$port"

    public companion object {
        /**
         * Reads `host:port`, `[address]:port`, or the host alone if [defaultPort] is given. `localhost` is 127.0.0.1.
         *
         * @param source what holds it, for messages
         * @throws InputException that names what is wrong
         */
        @JvmStatic
        @JvmOverloads
        public fun parse(text: String, source: String, defaultPort: Int? = null): HostPort {
            val word = text.trim()
            val colon = if (word.startsWith("[")) word.indexOf(']') + 1 else word.indexOf(':')
            if (word.startsWith("[") && colon == 0) throw wrong(source, text, "the bracket ] is missing")
            val tail = if (colon in 0 until word.length) word.substring(colon) else ""
            if (!word.startsWith("[") && ':' in tail.drop(1)) {
                throw wrong(source, text, "an address of IPv6 goes in brackets, such as [::1]:25520")
            }
            val host = word.removeSuffix(tail).removeSurrounding("[", "]")
            if (!HOST.matches(host)) throw wrong(source, text, "'$host' is no name or address of a host")
            if (tail.isEmpty()) {
                val missing = "a port is needed, as in $host:25520"
                return HostPort(canonical(host), defaultPort ?: throw wrong(source, text, missing))
            }
            val port = tail.drop(1).toIntOrNull()?.takeIf { tail.startsWith(":") && it in 1..LAST_PORT }
            return HostPort(canonical(host), port ?: throw wrong(source, text, "the port must be in 1..$LAST_PORT"))
        }

        /**
         * Reads a list of them with commas between, which must not be empty.
         *
         * @throws InputException that names what is wrong
         */
        @JvmStatic
        @JvmOverloads
        public fun parseList(text: String, source: String, defaultPort: Int? = null): List<HostPort> =
            text.split(',').map { parse(it, source, defaultPort) }

        /** [host] in the one way in which all processes write it. */
        internal fun canonical(host: String) = if (host == "localhost") "127.0.0.1" else host

        private fun wrong(source: String, text: String, what: String) = InputException(source, null, "'$text': $what")

        /** The last number of a port. */
        public const val LAST_PORT: Int = 65535

        /** The form of [host]. */
        internal val HOST = Regex("[A-Za-z0-9_]([A-Za-z0-9._-]*[A-Za-z0-9_])?|[0-9A-Fa-f:]*:[0-9A-Fa-f:.]*(%\\w+)?")
    }
}
