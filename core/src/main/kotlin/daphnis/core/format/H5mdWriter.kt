package daphnis.core.format

import daphnis.core.format.hdf5.Datatype
import daphnis.core.format.hdf5.GrowingDataset
import daphnis.core.format.hdf5.Hdf5File
import daphnis.core.format.hdf5.Hdf5Group
import daphnis.core.format.hdf5.Hdf5Object
import daphnis.core.population.SphereQuantity
import java.io.IOException
import java.nio.ByteBuffer

/**
 * Writes states of the same spheres into an H5MD file, one after the other. Of a state that was [added][add] only ids
 * are kept, which must be the same in all, edges, and masses, radii and materials of the first one; its other numbers are in the
 * file, or in a chunk that is not yet full.
 *
 * @param first the first state, which is not added by this
 * @param names names of units that every dataset gets; null for none
 */
internal class H5mdWriter(
    private val file: Hdf5File,
    first: Snapshot,
    version: String,
    private val names: UnitNames?,
) {
    private val firstStep = first.step
    private val id = first.id
    private val bound = first.bound
    private val optional = optional(first)
    private val checksum = H5mdChecksum(first)

    private val all: Hdf5Group
    private val box: Hdf5Group
    private val parameters: Hdf5Group
    private val step = GrowingDataset(file, Datatype.LONG, IntArray(0), isPacked = false)
    private val time = number().unit(names?.time)
    private val offset = number().unit(names?.length)
    private val edges = if (first.lengths.none { it.isNaN() }) H5mdEdges() else null
    private val changing = LinkedHashMap<SphereQuantity, GrowingDataset>()

    /** Numbers that no state has changed yet, and those that some have. */
    private val fixed = H5md.FIXED.associateWithTo(LinkedHashMap()) { first.columns(it)[0] }
    private val changed = LinkedHashMap<SphereQuantity, GrowingDataset>()
    private val species = if (first.hasMaterials) first.material else null
    private var changedSpecies: GrowingDataset? = null
    private var count = 0

    /** Null from the first state on that does not know them. */
    private var image = if (first.size > 0 && first.image != null) vectors(Datatype.INT, 3) else null

    init {
        file.root.group("h5md").describe(version)
        val particles = file.root.group("particles")
        all = particles.group("all")
        box = all.group("box")
        box.attribute("dimension", 3)
        box.attribute("boundary", List(3) { if (first.periodic[it]) "periodic" else "none" })
        // As it is written here the file has no datasets of size 0, so a state without particles has step and time.
        if (first.size == 0) {
            element("position", null)
        } else {
            for (quantity in H5md.CHANGING) {
                if (quantity !in first.quantities) continue
                val value = vectors(Datatype.DOUBLE, quantity.columns.size).unit(names?.of(quantity))
                changing[quantity] = value
                element(quantity.title, value)
            }
            all.dataset("id", first.id)
        }
        parameters = file.root.group("parameters")
        parameters.put("shear_offset", offset)
        parameters.dataset("shear_axes", intArrayOf(first.normalAxis, first.slideAxis))
        if (first.hasMaterials && first.materials.isNotEmpty()) {
            parameters.attribute(H5md.MATERIALS, first.materials)
        }
    }

    private fun Hdf5Group.describe(version: String) {
        attribute("version", 1, 1)
        group("author").attribute("name", System.getProperty("user.name") ?: "unknown")
        val creator = group("creator")
        creator.attribute("name", "daphnis")
        creator.attribute("version", version)
        if (names == null) return
        val module = group("modules").group("units")
        module.attribute("version", 1, 0)
        module.attribute("system", "SI")
    }

    private fun number() = GrowingDataset(file, Datatype.DOUBLE, IntArray(0), isPacked = false)

    private fun vectors(type: Datatype, width: Int): GrowingDataset {
        val frame = if (width == 1) intArrayOf(id.size) else intArrayOf(id.size, width)
        return GrowingDataset(file, type, frame, isPacked = true)
    }

    /** A group with steps and times, which are the same dataset in all, and [value]. */
    private fun element(name: String, value: GrowingDataset?, group: Hdf5Group = all) {
        val element = group.group(name)
        element.put("step", step)
        element.put("time", time)
        if (value != null) element.put("value", value)
    }

    /**
     * Adds [state].
     *
     * @throws IllegalArgumentException when it is of other spheres than the first one
     */
    @Throws(IOException::class)
    fun add(state: Snapshot) {
        require(state.id.contentEquals(id)) {
            "spheres differ between steps $firstStep and ${state.step}; H5MD needs the same in every frame"
        }
        require(optional(state) == optional) {
            "spheres have other quantities in step ${state.step} than in step $firstStep; " +
                "H5MD needs the same in every frame"
        }
        checksum.add(state)
        step.append { buffer, _, _ -> buffer.putLong(state.step) }
        time.append { buffer, _, _ -> buffer.putDouble(state.time) }
        offset.append { buffer, _, _ -> buffer.putDouble(state.shearOffset) }
        edges?.add(state)
        for ((quantity, value) in changing) {
            val columns = state.columns(quantity)
            value.append { buffer, from, until -> put(buffer, columns, from, until) }
        }
        if (id.isNotEmpty()) {
            for (quantity in H5md.FIXED) addNumbers(quantity, state.columns(quantity)[0])
            addSpecies(state.material)
        }
        count++
        val boxes = state.image
        if (boxes == null) image = null
        image?.append { buffer, from, until ->
            for (k in from until until) for (axis in 0..2) buffer.putInt(boxes!![axis][k])
        }
    }

    /** Of spheres that swap places. */
    private fun addSpecies(numbers: DoubleArray) {
        val before = species ?: return
        var value = changedSpecies
        if (value == null) {
            if (before.contentEquals(numbers)) return
            value = vectors(Datatype.INT, 1)
            changedSpecies = value
            repeat(count) { value.append { buffer, from, until -> putInts(buffer, before, from, until) } }
        }
        value.append { buffer, from, until -> putInts(buffer, numbers, from, until) }
    }

    private fun putInts(buffer: ByteBuffer, numbers: DoubleArray, from: Int, until: Int) {
        for (k in from until until) buffer.putInt(numbers[k].toInt())
    }

    /** Once [numbers] are others than those of the states before, which were all the same, each state has its own. */
    private fun addNumbers(quantity: SphereQuantity, numbers: DoubleArray) {
        val before = fixed[quantity]
        if (before != null) {
            if (before.contentEquals(numbers)) return
            fixed -= quantity
            val value = vectors(Datatype.DOUBLE, 1).unit(names?.of(quantity))
            changed[quantity] = value
            repeat(count) { value.append { buffer, from, until -> put(buffer, listOf(before), from, until) } }
        }
        changed.getValue(quantity).append { buffer, from, until -> put(buffer, listOf(numbers), from, until) }
    }

    private fun put(buffer: ByteBuffer, columns: List<DoubleArray>, from: Int, until: Int) {
        for (k in from until until) for (column in columns.indices) buffer.putDouble(columns[column][k])
    }

    /** Writes what is only known of all states. */
    @Throws(IOException::class)
    fun finish() {
        if (id.isNotEmpty()) {
            for ((quantity, numbers) in fixed) all.dataset(quantity.title, numbers).unit(names?.of(quantity))
            if (species != null && changedSpecies == null) {
                all.dataset(H5md.SPECIES, IntArray(id.size) { species[it].toInt() })
            }
        }
        changedSpecies?.let { element(H5md.SPECIES, it) }
        for ((quantity, value) in changed) element(quantity.title, value)
        edges?.let { element("edges", it.dataset(file).unit(names?.length), box) }
        image?.let { element("image", it) }
        // Of several states each would have other pairs.
        if (count == 1 && bound != null) {
            parameters.attribute(H5md.BOUND, bound.size / 2L)
            if (bound.isNotEmpty()) file.root.group(H5md.CONNECTIVITY).dataset(H5md.BOUND, bound)
        }
        parameters.attribute(H5mdChecksum.ATTRIBUTE, checksum.value())
        file.finish()
    }

    /** The unit as the module `units` writes it: symbols with powers, a string of fixed length. */
    private fun <D : Hdf5Object> D.unit(name: String?): D {
        if (name != null) attribute("unit", name)
        return this
    }

    class UnitNames(val length: String, val time: String, val mass: String) {
        fun of(quantity: SphereQuantity): String = quantity.dimension.symbols(length, time, mass)
    }

    private fun optional(state: Snapshot) = (H5md.CHANGING + SphereQuantity.MATERIAL).filter {
        it.isOptional &&
            it in state.quantities
    }
}
