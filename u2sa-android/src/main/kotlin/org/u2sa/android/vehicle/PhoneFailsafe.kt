package org.u2sa.android.vehicle

import org.u2sa.interfaces.time.Clock

/**
 * Failsafe for the phone and its connections. Covers what the Safety Manager cannot see: the phone's battery, temperature and
 * Bluetooth socket. For the position it is a second line behind the Safety Manager.
 */
class PhoneFailsafe(private val lowBatteryPercent: Double) {
    /** Hazards of the phone. */
    enum class Hazard {
        BOARD_LOST,
        POSITION_LOST,
        BATTERY_LOW,
        TOO_HOT,
    }

    /**
     * Active hazards, worst first.
     *
     * @param stateAgeMicros age of the newest state with a position [µs]; null before the first
     */
    fun hazards(phone: PhoneCondition.Reading, boardConnected: Boolean?, stateAgeMicros: Long?): List<Hazard> {
        return buildList {
            if (boardConnected == false) {
                add(Hazard.BOARD_LOST)
            }
            if (stateAgeMicros == null || stateAgeMicros > POSITION_TIMEOUT_MICROS) {
                add(Hazard.POSITION_LOST)
            }
            if (phone.batteryPercent != null && phone.batteryPercent < lowBatteryPercent && !phone.charging) {
                add(Hazard.BATTERY_LOW)
            }
            if (phone.heat != null && phone.heat >= PhoneCondition.Heat.SEVERE) { // Android throttles the CPU from this level
                add(Hazard.TOO_HOT)
            }
        }
    }

    companion object {
        /** Age at which the position counts as lost; longer than the Safety Manager's own timeout. */
        val POSITION_TIMEOUT_MICROS: Long = Clock.micros(3.0)
    }
}
