package org.u2sa.android.sensor

/** A camera that sees what a test shows it. */
class TestCamera : PhoneCamera {
    @Volatile var picture: PhoneCamera.Picture? = null
    @Volatile override var trouble = ""
    @Volatile var isClosed = false

    override fun latest() = picture

    override fun close() {
        isClosed = true
    }
}
