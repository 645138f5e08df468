package org.u2sa.android.sensor

import kotlin.math.pow

/** Altitude from the pressure of the air. */
internal object Barometer {
    /** Standard deviation of such an altitude [m]: the weather moves the pressure at sea level by some 12 hPa. */
    const val SIGMA_M = 100.0

    private const val SEA_LEVEL_PA = 101_325.0
    private const val SCALE_M = 44_330.77 // T₀ / L of the ISO 2533 standard atmosphere
    private const val EXPONENT = 0.190263 // R L / g

    /** Pressure altitude [m] in the standard atmosphere (ISO 2533, below 11 km). */
    fun altitudeM(pascals: Double): Double = SCALE_M * (1.0 - (pascals / SEA_LEVEL_PA).pow(EXPONENT))
}
