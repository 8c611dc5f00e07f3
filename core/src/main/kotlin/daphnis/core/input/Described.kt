package daphnis.core.input

import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialInfo

/**
 * What a key of a scenario means, or a `type` of an object in it, for those who write scenarios: the schema of scenarios
 * and `docs/reference/scenario-keys.md` are made of it.
 *
 * @property text the meaning, with unit and bounds, and of a key that may be left out, behind `; default `, what holds
 *   then; Markdown without links
 */
@OptIn(ExperimentalSerializationApi::class)
@SerialInfo
@Target(AnnotationTarget.PROPERTY, AnnotationTarget.CLASS)
@MustBeDocumented
public annotation class Described(val text: String)
