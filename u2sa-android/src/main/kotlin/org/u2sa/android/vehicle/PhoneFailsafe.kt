package org.u2sa.android.vehicle

import org.u2sa.interfaces.time.Clock

/**
 * What is wrong with the phone or its connections, and whether the vehicle may go on with it. It knows what the Safety Manager
 * cannot: the phone's battery and heat, the Bluetooth socket. For the position it is the second line, behind the Safety Manager.
 */
class PhoneFailsafe(private val lowBatteryPercent: Double) {
    /** What can be wrong. */
    enum class Hazard {
        BOARD_LOST,
        POSITION_LOST,
        BATTERY_LOW,
        TOO_HOT,
    }

    /**
     * All that speaks against moving now, the worst first.
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
            if (phone.heat != null && phone.heat >= PhoneCondition.Heat.SEVERE) { // from here on Android slows the processor down
                add(Hazard.TOO_HOT)
            }
        }
    }

    companion object {
        /** Age from which the position counts as lost: later than the Safety Manager's own deadline. */
        val POSITION_TIMEOUT_MICROS: Long = Clock.micros(3.0)
    }
}
