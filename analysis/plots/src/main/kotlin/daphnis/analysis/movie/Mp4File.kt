package daphnis.analysis.movie

import org.jcodec.codecs.h264.H264Encoder
import org.jcodec.codecs.h264.encode.RateControl
import org.jcodec.codecs.h264.io.model.SeqParameterSet
import org.jcodec.codecs.h264.io.model.SliceType
import org.jcodec.codecs.h264.io.model.VUIParameters
import org.jcodec.common.Codec
import org.jcodec.common.io.FileChannelWrapper
import org.jcodec.common.model.Packet
import org.jcodec.common.model.Size
import org.jcodec.containers.mp4.Brand
import org.jcodec.containers.mp4.MP4TrackType
import org.jcodec.containers.mp4.muxer.CodecMP4MuxerTrack
import org.jcodec.containers.mp4.muxer.MP4Muxer
import java.awt.image.BufferedImage
import java.awt.image.DataBufferInt
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE

/**
 * MP4 with H.264 in its baseline profile, by jcodec. Colour is stored for two by two pixels, so [width] and [height]
 * must be even.
 */
internal class Mp4File(
    path: Path,
    private val width: Int,
    private val height: Int,
    private val framesPerSecond: Double,
) : MovieFile {
    init {
        require(width % 2 == 0 && height % 2 == 0) { "frames are $width × $height pixels; both must be even for MP4" }
    }

    override val writer: String = "jcodec"
    private val channel = FileChannel.open(path, CREATE, TRUNCATE_EXISTING, READ, WRITE)
    private val muxer = MP4Muxer.createMP4Muxer(FileChannelWrapper(channel), Brand.MP4)
    private val track = CodecMP4MuxerTrack(1, MP4TrackType.VIDEO, Codec.H264).also { muxer.addTrack(it) }
    private val encoder = Encoder()
    private val picture = YuvPicture(width, height)

    // A frame of noise at the encoder's least step takes less than the picture itself.
    private val buffer = ByteBuffer.allocate(4 * width * height + LEAST_BUFFER)
    private var frames = 0L

    override fun add(image: BufferedImage) {
        picture.take((image.raster.dataBuffer as DataBufferInt).data)
        buffer.clear()
        val frame = encoder.encodeFrame(picture.picture, buffer)
        val start = ticks(frames)
        val type = if (frame.isKeyFrame) Packet.FrameType.KEY else Packet.FrameType.INTER
        val duration = ticks(frames + 1) - start
        track.addFrame(Packet.createPacket(frame.data, start, TICKS, duration, frames, type, null))
        frames++
    }

    private fun ticks(frame: Long) = Math.round(frame * TICKS / framesPerSecond)

    override fun finish(): Unit = muxer.finish()

    override fun close(): Unit = channel.close()

    /** With the level that the frame needs, and what the colours mean. */
    private class Encoder : H264Encoder(SameSteps) {
        override fun initSPS(size: Size): SeqParameterSet = super.initSPS(size).apply {
            val blocks = (picWidthInMbsMinus1 + 1) * (picHeightInMapUnitsMinus1 + 1)
            levelIdc = LEVELS.first { blocks <= it.second }.first
            vuiParams = VUIParameters().apply {
                videoSignalTypePresentFlag = true
                videoFormat = UNSPECIFIED
                colourDescriptionPresentFlag = true
                colourPrimaries = BT_709
                transferCharacteristics = BT_709
                matrixCoefficients = BT_709
            }
        }
    }

    /**
     * One step of quantisation throughout, the coarsest at which decoders leave the edges of blocks alone: the encoder
     * predicts blocks from others whose edges it has smoothed already, which is not what decoders do, and colours
     * drift away over a frame.
     */
    private object SameSteps : RateControl {
        private const val STEP = 15

        override fun startPicture(size: Size, most: Int, type: SliceType): Int = STEP

        override fun initialQpDelta(): Int = 0

        override fun accept(bits: Int): Int = 0
    }

    companion object {
        /** As the constructor, wherever the library is: its jar has no name of a module, and may be on the class path. */
        fun open(path: Path, width: Int, height: Int, framesPerSecond: Double): Mp4File {
            Mp4File::class.java.module.addReads(Class.forName("org.jcodec.codecs.h264.H264Encoder").module)
            return Mp4File(path, width, height, framesPerSecond)
        }

        /** A second; whole for the usual rates. */
        private const val TICKS = 90_000
        private const val LEAST_BUFFER = 1 shl 16
        private const val BT_709 = 1
        private const val UNSPECIFIED = 5

        /** Levels, and the most blocks of 16 × 16 pixels of their frames (H.264, table A-1). */
        private val LEVELS = listOf(40 to 8192, 51 to 36_864, 60 to 139_264)
    }
}
