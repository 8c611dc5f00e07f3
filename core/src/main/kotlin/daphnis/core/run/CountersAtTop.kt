package daphnis.core.run

import daphnis.core.collision.Counter
import kotlinx.serialization.KSerializer
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonTransformingSerializer
import kotlinx.serialization.json.jsonObject

/** [T] with its `counted`, a number for each [Counter] by its key, among its other properties. */
internal class CountersAtTop<T : Any>(serializer: KSerializer<T>) : JsonTransformingSerializer<T>(serializer) {
    override fun transformSerialize(element: JsonElement): JsonElement =
        JsonObject(element.jsonObject - COUNTED + element.jsonObject.getValue(COUNTED).jsonObject)

    override fun transformDeserialize(element: JsonElement): JsonElement {
        val counted = element.jsonObject.filterKeys { it in KEYS }
        return JsonObject(element.jsonObject - KEYS + (COUNTED to JsonObject(counted)))
    }

    private companion object {
        const val COUNTED = "counted"
        val KEYS = Counter.entries.map { it.key }.toSet()
    }
}
