package org.u2sa.android.vehicle

/** What the phone says of itself as a computer: a real one and one of a test look alike. */
fun interface PhoneCondition {
    /**
     * @property batteryPercent charge left, 0…100; null if unknown
     * @property charging whether it is fed from outside
     * @property heat how hot it is; null if the phone cannot say (before Android 10)
     */
    class Reading(val batteryPercent: Double?, val charging: Boolean, val heat: Heat?)

    /** Android's thermal status, the coolest first. */
    enum class Heat { NONE, LIGHT, MODERATE, SEVERE, CRITICAL, EMERGENCY, SHUTDOWN }

    /** Returns at once. */
    fun read(): Reading
}
