package org.u2sa.android.vehicle

/** Condition of the phone as a computer: real or simulated. */
fun interface PhoneCondition {
    /**
     * @property batteryPercent charge left, 0…100; null if unknown
     * @property charging whether it is charging or externally powered
     * @property heat thermal status; null if unknown (before Android 10)
     */
    class Reading(val batteryPercent: Double?, val charging: Boolean, val heat: Heat?)

    /** Android's thermal status, coolest first. */
    enum class Heat { NONE, LIGHT, MODERATE, SEVERE, CRITICAL, EMERGENCY, SHUTDOWN }

    /** Returns immediately. */
    fun read(): Reading
}
