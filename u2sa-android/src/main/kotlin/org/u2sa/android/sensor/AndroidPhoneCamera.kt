package org.u2sa.android.sensor

import android.Manifest
import android.content.Context
import android.content.pm.PackageManager
import android.graphics.ImageFormat
import android.hardware.camera2.CameraAccessException
import android.hardware.camera2.CameraCaptureSession
import android.hardware.camera2.CameraCharacteristics
import android.hardware.camera2.CameraDevice
import android.hardware.camera2.CameraManager
import android.media.Image
import android.media.ImageReader
import android.os.Handler
import android.os.HandlerThread
import java.nio.Buffer
import java.util.Optional
import org.u2sa.device.port.Camera
import org.u2sa.device.port.CameraFrame
import org.u2sa.interfaces.time.Clock

private const val WIDTH = 640
private const val HEIGHT = 480
private const val PICTURES_HELD = 2

/**
 * The phone's rear camera, 640 × 480. Callbacks run on a dedicated thread that ends with [close]. Losing the camera to another
 * app is reported as trouble, not as an exception; the next vehicle start reopens it.
 */
class AndroidPhoneCamera(private val context: Context, private val clock: Clock) : Camera {
    private val thread = HandlerThread("u2sa-phone-camera").apply { start() }
    private val handler = Handler(thread.looper)
    private val reader = ImageReader.newInstance(WIDTH, HEIGHT, ImageFormat.YUV_420_888, PICTURES_HELD)
    private var device: CameraDevice? = null // confined to that thread
    @Volatile private var age = PictureAge.of(null)

    @Volatile private var frame: Optional<CameraFrame> = Optional.empty()
    @Volatile private var isClosed = false
    @Volatile private var trouble = "the camera is being opened"
    @Volatile private var connections = 0

    private val opening = object : CameraDevice.StateCallback() {
        override fun onOpened(camera: CameraDevice) {
            if (isClosed) {
                camera.close()
                return
            }
            device = camera
            trying { watch(camera) }
        }

        override fun onDisconnected(camera: CameraDevice) = lost(camera, "another application took the camera")

        override fun onError(camera: CameraDevice, error: Int) = lost(camera, "the camera failed, error $error")
    }

    init {
        reader.setOnImageAvailableListener({ take(it) }, handler)
        trying { open() }
    }

    private fun open() {
        val manager = context.getSystemService(Context.CAMERA_SERVICE) as CameraManager
        val back = manager.cameraIdList.firstOrNull {
            manager.getCameraCharacteristics(it).get(CameraCharacteristics.LENS_FACING) == CameraCharacteristics.LENS_FACING_BACK
        }
        when {
            context.checkSelfPermission(Manifest.permission.CAMERA) != PackageManager.PERMISSION_GRANTED ->
                trouble = "camera permission was denied"
            back == null -> trouble = "the phone has no rear camera"
            else -> {
                age = PictureAge.of(manager.getCameraCharacteristics(back).get(CameraCharacteristics.SENSOR_INFO_TIMESTAMP_SOURCE))
                manager.openCamera(back, opening, handler)
            }
        }
    }

    @Suppress("DEPRECATION") // the replacement needs Android 9 and an executor; this one works everywhere
    private fun watch(camera: CameraDevice) {
        camera.createCaptureSession(
            listOf(reader.surface),
            object : CameraCaptureSession.StateCallback() {
                override fun onConfigured(session: CameraCaptureSession) = trying {
                    val request = camera.createCaptureRequest(CameraDevice.TEMPLATE_PREVIEW).apply { addTarget(reader.surface) }
                    session.setRepeatingRequest(request.build(), null, handler)
                    connections++ // confined to this thread
                    trouble = ""
                }

                override fun onConfigureFailed(session: CameraCaptureSession) {
                    trouble = "the camera does not support pictures of $WIDTH by $HEIGHT"
                }
            },
            handler,
        )
    }

    private fun trying(action: () -> Unit) {
        try {
            action()
        } catch (e: CameraAccessException) {
            trouble = "the camera: ${e.message}"
        } catch (e: IllegalStateException) { // closed by Android in the meantime
            trouble = "the camera: ${e.message}"
        }
    }

    private fun lost(camera: CameraDevice, words: String) {
        trouble = words
        device = null
        camera.close()
    }

    private fun take(from: ImageReader) {
        from.acquireLatestImage()?.use { image ->
            frame = Optional.of(CameraFrame.grey(clock.micros() - age.micros(image.timestamp), image.width, image.height, grey(image)))
        }
    }

    /** Luma plane of a YUV image, without row padding. */
    private fun grey(image: Image): ByteArray {
        val plane = image.planes[0]
        val bytes = ByteArray(image.width * image.height)
        for (row in 0 until image.height) {
            moveTo(plane.buffer, row * plane.rowStride)
            plane.buffer.get(bytes, row * image.width, image.width)
        }
        return bytes
    }

    /** Cast to Buffer because ByteBuffer's covariant override is missing on Android 8. */
    private fun moveTo(buffer: Buffer, place: Int) {
        buffer.position(place)
    }

    override fun read(nowMicros: Long): Optional<CameraFrame> = frame

    override fun isConnected() = trouble.isEmpty()

    override fun connections() = connections

    override fun trouble() = trouble

    override fun close() {
        isClosed = true
        handler.post {
            device?.close()
            reader.close()
        }
        thread.quitSafely()
    }
}
