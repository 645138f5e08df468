package org.u2sa.android.sensor

import java.util.Optional
import org.u2sa.device.port.Camera
import org.u2sa.device.port.CameraFrame

/** A camera that nothing stands before. */
class TestCamera : Camera {
    @Volatile var isClosed = false

    override fun read(nowMicros: Long): Optional<CameraFrame> = Optional.empty()

    override fun close() {
        isClosed = true
    }
}
