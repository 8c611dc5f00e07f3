package daphnis.cluster.wire

import daphnis.cluster.security.Secret
import org.apache.pekko.actor.ExtendedActorSystem
import org.apache.pekko.cluster.ClusterMessage
import org.apache.pekko.cluster.protobuf.ClusterMessageSerializer
import org.apache.pekko.serialization.SerializationSetup
import org.apache.pekko.serialization.SerializerDetails
import org.apache.pekko.serialization.SerializerWithStringManifest
import java.io.NotSerializableException

/**
 * What Pekko's clusters say to each other, such as who joins and who is given up, each behind a proof of the [secret].
 * What comes without one is dropped as damaged: who reaches the port can neither join nor declare others lost.
 * (ADR 128)
 */
internal class SealedMembership(system: ExtendedActorSystem, private val secret: Secret) :
    SerializerWithStringManifest() {
    private val usual = ClusterMessageSerializer(system)

    override fun identifier(): Int = usual.identifier()

    override fun manifest(message: Any): String = usual.manifest(message)

    override fun toBinary(message: Any): ByteArray {
        val bytes = usual.toBinary(message)
        return proof(bytes, manifest(message)) + bytes
    }

    override fun fromBinary(bytes: ByteArray, manifest: String): Any {
        if (bytes.size < PROOF) throw NotSerializableException("a message of the cluster that is cut short")
        val message = bytes.copyOfRange(PROOF, bytes.size)
        if (!Secret.same(proof(message, manifest), bytes.copyOf(PROOF))) {
            throw NotSerializableException("a message of the cluster from a process with another secret")
        }
        return usual.fromBinary(message, manifest)
    }

    private fun proof(message: ByteArray, manifest: String) = secret.proof(SIDE, manifest.toByteArray(), message)

    companion object {
        /** Bytes of a proof. */
        private const val PROOF = 32
        private val SIDE = "membership".toByteArray()

        /** Takes the place of Pekko's own serializer in a system. */
        fun setup(secret: Secret): SerializationSetup = SerializationSetup.create { system ->
            val bound = listOf<Class<*>>(ClusterMessage::class.java)
            listOf(SerializerDetails.create("pekko-cluster", SealedMembership(system, secret), bound))
        }
    }
}
