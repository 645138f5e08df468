package org.u2sa.android.vehicle

import java.util.OptionalDouble
import java.util.TreeMap
import kotlin.math.hypot
import org.u2sa.interfaces.time.Clock
import org.u2sa.messages.BatteryState
import org.u2sa.messages.goal.GoalInformation
import org.u2sa.messages.goal.GoalList
import org.u2sa.messages.StateInformation
import org.u2sa.messages.schema.U2SAData
import org.u2sa.messages.goal.Waypoint
import org.u2sa.messages.safety.ArmingState
import org.u2sa.messages.contract.Condition
import org.u2sa.messages.safety.FailsafeAction
import org.u2sa.messages.safety.FailsafeState
import org.u2sa.messages.contract.HealthReport
import org.u2sa.messages.contract.ServiceCondition
import org.u2sa.messages.contract.ServiceStatus
import org.u2sa.messages.frame.Geodetic
import org.u2sa.messages.frame.ReferenceFrame

private const val TRACK_STEP_M = 0.3
private const val TRACK_POINTS_AT_MOST = 3_000

/** Builds snapshots from a vehicle's messages. Not thread-safe; owned by one [Cockpit]. */
internal class SnapshotMaker {
    private var arming: ArmingState? = null
    private var failsafe: FailsafeState? = null
    private var state: StateInformation? = null
    private var goals: GoalList? = null
    private val reports = TreeMap<String, HealthReport>()
    private val conditions = TreeMap<String, ServiceCondition>()
    private val batteries = TreeMap<String, VehicleSnapshot.Battery>()
    private val track = ArrayDeque<Geodetic>()

    /** Whether the vehicle reported being armed. */
    val armed: Boolean get() = arming?.armed() ?: false

    /** @return whether the message was used */
    fun see(message: U2SAData): Boolean {
        when (message) {
            is StateInformation -> if (place(message) != null) seeState(message)
            is ArmingState -> arming = message
            is FailsafeState -> failsafe = message
            is GoalList -> goals = message
            is HealthReport -> reports[message.serviceName()] = message
            is ServiceCondition -> conditions[message.serviceName()] = message
            is BatteryState -> batteries[message.sensorName()] =
                VehicleSnapshot.Battery(message.voltage().orNull(), message.remaining().orNull())
            else -> return false
        }
        return true
    }

    private fun seeState(message: StateInformation) {
        state = message
        val here = place(message) ?: return
        if (track.isEmpty() || track.last().distanceM(here) >= TRACK_STEP_M) {
            track.addLast(here)
            if (track.size > TRACK_POINTS_AT_MOST) {
                track.removeFirst()
            }
        }
    }

    private fun place(message: StateInformation): Geodetic? {
        val fits = message.referenceFrame() == ReferenceFrame.GLOBAL && message.timestamp().isPresent
        val x = message.x().orNull()
        val y = message.y().orNull()
        return if (fits && x != null && y != null && y in -90.0..90.0) Geodetic(x, y, 0.0) else null
    }

    /** Age of the latest position [µs]; null before the first. */
    fun stateAgeMicros(nowMicros: Long): Long? = state?.let { nowMicros - it.timestamp().asLong }

    fun snapshot(nowMicros: Long, hazards: List<PhoneFailsafe.Hazard>, emergency: String?) = VehicleSnapshot(
        armed = armed,
        armingReasons = arming?.reasons().orEmpty(),
        emergency = emergency,
        failsafe = failsafe?.action() ?: FailsafeAction.CONTINUE,
        causes = failsafe?.causes().orEmpty(),
        hazards = hazards,
        services = reports.keys.union(conditions.keys).sorted().map(::line),
        motion = state?.let { motion(it, nowMicros) },
        track = track.toList(),
        goals = goals(),
        batteries = TreeMap(batteries),
    )

    private fun line(name: String): VehicleSnapshot.ServiceLine {
        val condition = conditions[name]
        val report = reports[name]
        if (condition != null && condition.condition() != Condition.ALIVE) {
            val words = listOf(condition.condition().name, condition.reason(), condition.action())
            return VehicleSnapshot.ServiceLine(name, false, words.filter(String::isNotEmpty).joinToString(", "))
        }
        val status = report?.status() ?: ServiceStatus.RUNNING
        return VehicleSnapshot.ServiceLine(name, status == ServiceStatus.RUNNING, status.name)
    }

    private fun motion(newest: StateInformation, nowMicros: Long): VehicleSnapshot.Motion? {
        val east = newest.xDot().orNull()
        val north = newest.yDot().orNull()
        val sigmas = listOfNotNull(newest.xSigma().orNull(), newest.ySigma().orNull())
        return place(newest)?.let {
            VehicleSnapshot.Motion(
                place = it,
                headingRad = newest.psi().orNull(),
                speedMps = if (east != null && north != null) hypot(east, north) else null,
                sigmaM = sigmas.maxOrNull(),
                ageS = Clock.seconds(nowMicros - newest.timestamp().asLong),
            )
        }
    }

    private fun goals(): List<VehicleSnapshot.Goal> {
        val list = goals ?: return emptyList()
        return list.goals().mapNotNull { goal(it, true) } + list.upcoming().mapNotNull { goal(it, false) }
    }

    private fun goal(information: GoalInformation, current: Boolean): VehicleSnapshot.Goal? {
        val waypoint = information as? Waypoint ?: return null
        val x = waypoint.x().orNull()
        val y = waypoint.y().orNull()
        val drawable = waypoint.referenceFrame() == ReferenceFrame.GLOBAL && x != null && y != null
        return if (drawable) VehicleSnapshot.Goal(waypoint.uid(), Geodetic(x!!, y!!, 0.0), current) else null
    }

    private fun OptionalDouble.orNull(): Double? = if (isPresent) asDouble else null
}
