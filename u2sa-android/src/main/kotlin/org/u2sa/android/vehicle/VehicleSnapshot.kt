package org.u2sa.android.vehicle

import org.u2sa.messages.contract.FailsafeAction
import org.u2sa.messages.frame.Geodetic

/**
 * All that a screen shows of a vehicle, as of one moment. Immutable.
 *
 * @property armed whether it may move
 * @property armingReasons what speaks against arming it
 * @property emergency who stopped it and why; null if no emergency stop holds
 * @property failsafe what it does because something is wrong
 * @property causes what is wrong, in the Safety Manager's words
 * @property hazards what is wrong with the phone or its connections
 * @property services how each is, in the order of their names
 * @property motion where it is; null if it does not know
 * @property track where it was, the oldest first
 * @property goals of its mission, the current one first
 * @property batteries by the name of what measured each
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
    /** One service: [healthy], or what is wrong in [words]. */
    data class ServiceLine(val name: String, val healthy: Boolean, val words: String)

    /**
     * Where the vehicle is.
     *
     * @property headingRad clockwise from true north; null if unknown
     * @property speedMps over ground; null if unknown
     * @property sigmaM standard deviation of the position; null if unknown
     * @property ageS since it was measured
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

    /** A battery: what is null it does not say. */
    data class Battery(val volts: Double?, val percent: Double?)
}
