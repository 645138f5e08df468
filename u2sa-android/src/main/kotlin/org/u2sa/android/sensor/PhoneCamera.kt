package org.u2sa.android.sensor

/** All that a [CameraSensor] knows of the phone's camera: a real one and one of a test look alike. */
interface PhoneCamera : AutoCloseable {
    /**
     * One picture, in shades of grey.
     *
     * @property measuredAtMicros when its exposure began, on the run's clock
     * @property widthPixels of a row
     * @property heightPixels number of rows, from the top of the sensor
     * @property grey brightness row by row, 0 black to 255 white as unsigned bytes; not to be changed
     */
    class Picture(val measuredAtMicros: Long, val widthPixels: Int, val heightPixels: Int, val grey: ByteArray)

    /** What is wrong, in words; empty if nothing. */
    val trouble: String

    /** The newest picture; null if there was none yet. Returns at once. */
    fun latest(): Picture?

    override fun close()
}
