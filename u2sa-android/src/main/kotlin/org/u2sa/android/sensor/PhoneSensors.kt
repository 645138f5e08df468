package org.u2sa.android.sensor

import org.u2sa.device.GpsFix
import org.u2sa.messages.frame.Point

/** All that [PhoneStateSensor] knows of a phone: a real one and one of a test look alike. */
interface PhoneSensors : AutoCloseable {
    /**
     * The newest of each sensor. Null: the phone has none, may not be asked, or has said nothing yet.
     *
     * @property fix of the phone's GPS
     * @property orientation of the phone
     * @property acceleration what the accelerometer feels, gravity included, along the phone's axes [m/s²]
     * @property turnRate of the gyroscope about the phone's axes [rad/s]
     * @property pressure of the air
     * @property trouble what is missing, in words; empty if nothing
     */
    class Reading(
        val fix: GpsFix? = null,
        val orientation: PhoneOrientation? = null,
        val acceleration: Sample? = null,
        val turnRate: Sample? = null,
        val pressure: Pressure? = null,
        val trouble: String = "",
    )

    /** A vector along the phone's axes, measured at [measuredAtMicros] of the run's clock. */
    class Sample(val measuredAtMicros: Long, val vector: Point)

    /** Pressure of the air [Pa], measured at [measuredAtMicros] of the run's clock. */
    class Pressure(val measuredAtMicros: Long, val pascals: Double)

    /** Returns at once. */
    fun read(): Reading

    override fun close()
}
