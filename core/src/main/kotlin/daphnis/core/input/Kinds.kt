package daphnis.core.input

import kotlinx.serialization.InternalSerializationApi
import kotlinx.serialization.KSerializer
import kotlinx.serialization.SealedClassSerializer
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import java.util.ServiceConfigurationError
import java.util.ServiceLoader
import kotlin.reflect.KClass

/**
 * The kinds of one ingredient of a scenario, such as its forces, each under the name by which `type` calls it in JSON:
 * those of daphnis, and those of other libraries on the class path, see [Ingredients]. A kind says everything that
 * others ask of it itself, so that nobody asks which one it is; docs/internals/adding.md tells how to add one.
 */
@OptIn(InternalSerializationApi::class)
public abstract class Kinds<T : Any>(ingredient: KClass<T>, own: List<Kind<out T>>) : KSerializer<T> {
    private val named by lazy {
        val all = (own + Ingredients.of(ingredient)).sortedBy { it.name }
        all.zipWithNext().find { (one, next) -> one.name == next.name }?.let { (one, next) ->
            throw InputException(
                LIBRARIES,
                null,
                "${one.type.java.name} and ${next.type.java.name} are both called '${one.name}'",
            )
        }
        val types = Array(all.size) { all[it].type }
        val serializers = Array(all.size) { all[it].serializer }
        SealedClassSerializer(ingredient.simpleName!!, ingredient, types, serializers)
    }

    override val descriptor: SerialDescriptor get() = named.descriptor

    override fun serialize(encoder: Encoder, value: T): Unit = encoder.encodeSerializableValue(named, value)

    override fun deserialize(decoder: Decoder): T = decoder.decodeSerializableValue(named)
}

/** A class that is a kind of an ingredient, with its [serializer], whose serial name is its name in JSON. */
public class Kind<T : Any>(public val type: KClass<T>, public val serializer: KSerializer<T>) {
    internal val name: String get() = serializer.descriptor.serialName
}

/**
 * Ingredients of a library beside daphnis. It names its implementation in
 * `META-INF/services/daphnis.core.input.Ingredients`; scenario files then know its kinds wherever it is on the class path.
 */
public interface Ingredients {
    /** Kinds, each of a class that implements the interface of its ingredient. */
    public val kinds: List<Kind<*>>

    public companion object {
        /**
         * Those of [ingredient] on the class path.
         *
         * @throws InputException for a library that cannot be used
         */
        internal fun <T : Any> of(ingredient: KClass<T>): List<Kind<out T>> = try {
            ServiceLoader.load(Ingredients::class.java).flatMap { it.kinds }
                .filter { ingredient.java.isAssignableFrom(it.type.java) }
                .map {
                    @Suppress("UNCHECKED_CAST")
                    it as Kind<out T>
                }
        } catch (e: ServiceConfigurationError) {
            throw InputException(LIBRARIES, null, e.message.orEmpty() + e.cause?.let { " ($it)" }.orEmpty())
        }
    }
}

private const val LIBRARIES = "ingredients of libraries"
