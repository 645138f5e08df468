package org.u2sa.android.vehicle

import org.u2sa.messages.safety.FailsafeAction
import org.u2sa.messages.frame.Geodetic

/**
 * Snapshot of everything a screen shows about a vehicle. Immutable.
 *
 * @property armed whether it may move
 * @property armingReasons reasons against arming
 * @property emergency who stopped it and why; null without an active emergency stop
 * @property failsafe active failsafe action
 * @property causes causes reported by the Safety Manager
 * @property hazards active hazards of the phone and its connections
 * @property services status of each service, ordered by name
 * @property motion position and motion; null if unknown
 * @property track past positions, oldest first
 * @property goals goals of the mission, current one first
 * @property batteries by name of the measuring sensor
 */
data class VehicleSnapshot(
    val armed: Boolean = false,
    val armingReasons: List<String> = emptyList(),
    val emergency: String? = null,
    val failsafe: FailsafeAction = FailsafeAction.CONTINUE,
    val causes: List<String> = emptyList(),
    val hazards: List<PhoneFailsafe.Hazard> = emptyList(),
    val services: List<ServiceLine> = emptyList(),
    val motion: Motion? = null,
    val track: List<Geodetic> = emptyList(),
    val goals: List<Goal> = emptyList(),
    val batteries: Map<String, Battery> = emptyMap(),
) {
    /** One service: [healthy], or the fault in [words]. */
    data class ServiceLine(val name: String, val healthy: Boolean, val words: String)

    /**
     * Position and motion of the vehicle.
     *
     * @property headingRad clockwise from true north; null if unknown
     * @property speedMps speed over ground; null if unknown
     * @property sigmaM standard deviation of the position; null if unknown
     * @property ageS age of the measurement
     */
    data class Motion(
        val place: Geodetic,
        val headingRad: Double?,
        val speedMps: Double?,
        val sigmaM: Double?,
        val ageS: Double,
    )

    /** A waypoint, by its name in the mission. */
    data class Goal(val name: String, val place: Geodetic, val current: Boolean)

    /** A battery; null values are not reported. */
    data class Battery(val volts: Double?, val percent: Double?)
}
