package org.u2sa.android.sensor

import org.u2sa.device.port.GpsFix
import org.u2sa.messages.frame.Point

/** The phone as seen by [PhoneStateSensor]: real or simulated. */
interface PhoneSensors : AutoCloseable {
    /**
     * Latest reading of each sensor; null if the sensor is absent, not permitted or has not reported yet.
     *
     * @property fix GPS fix
     * @property orientation orientation of the phone
     * @property acceleration specific force, including gravity, in phone axes [m/s²]
     * @property turnRate angular rate in phone axes [rad/s]
     * @property pressure air pressure
     * @property trouble description of what is missing; empty if nothing
     */
    class Reading(
        val fix: GpsFix? = null,
        val orientation: PhoneOrientation? = null,
        val acceleration: Sample? = null,
        val turnRate: Sample? = null,
        val pressure: Pressure? = null,
        val trouble: String = "",
    )

    /** A vector in phone axes, measured at [measuredAtMicros] of the run's clock. */
    class Sample(val measuredAtMicros: Long, val vector: Point)

    /** Air pressure [Pa], measured at [measuredAtMicros] of the run's clock. */
    class Pressure(val measuredAtMicros: Long, val pascals: Double)

    /** Returns immediately. */
    fun read(): Reading

    override fun close()
}
