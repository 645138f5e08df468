package org.u2sa.android.vehicle

import java.util.UUID
import org.u2sa.android.board.BoardCondition
import org.u2sa.interfaces.communication.Channels
import org.u2sa.interfaces.log.LogLevelEnum
import org.u2sa.messages.BatteryState
import org.u2sa.messages.safety.ArmCommand
import org.u2sa.messages.safety.EmergencyStop
import org.u2sa.messages.schema.U2SAData
import org.u2sa.service.actuator.EmergencyLatch
import org.u2sa.service.PeriodicService
import org.u2sa.service.ServiceContext
import org.u2sa.service.ServiceRole

private const val LOOKS_PER_S = 10.0
private const val REPORT_POWER_EVERY_S = 5.0

/**
 * The phone's operator service: displays vehicle status, issues operator commands, and stops the vehicle when the phone is no
 * longer fit to run it ([PhoneFailsafe]). In: state, goals, health, conditions, failsafe, arming-state,
 * emergency-stop, power. Out: emergency-stop, arming, and power for the phone's own battery. Thesis 4.6.
 *
 * A hazard stops an armed vehicle by an emergency stop that only an operator can clear; a stationary vehicle cannot be armed
 * while a hazard persists.
 */
class Cockpit(
    context: ServiceContext,
    private val phone: PhoneCondition,
    private val board: BoardCondition,
    private val failsafe: PhoneFailsafe,
) : PeriodicService(context, ServiceRole.OBSERVER, NAME, LOOKS_PER_S) {
    private val maker = SnapshotMaker()
    private val latch = EmergencyLatch(clock(), context.systemId())
    private var powerDueS = 0.0

    /** Latest snapshot. Thread-safe. */
    @Volatile
    var snapshot = VehicleSnapshot()
        private set

    @Volatile private var newestStop: EmergencyStop? = null

    init {
        listOf(
            Channels.STATE, Channels.GOALS, Channels.HEALTH, Channels.CONDITIONS, Channels.FAILSAFE, Channels.ARMING_STATE,
            Channels.EMERGENCY_STOP, Channels.POWER,
        ).forEach { registerSubscriber(it) }
        listOf(Channels.EMERGENCY_STOP, Channels.ARMING, Channels.POWER).forEach { registerPublisher(it) }
    }

    override fun callback(data: U2SAData) {
        if (data is EmergencyStop) {
            latch.accept(data)
            newestStop = latch.stop().orElse(null)
        } else if (!maker.see(data)) {
            unexpected(data)
        }
    }

    override fun step(nowS: Double) {
        val now = clock().micros()
        val reading = phone.read()
        val hazards = failsafe.hazards(reading, board.connected(), maker.stateAgeMicros(now))
        if (maker.armed && hazards.isNotEmpty() && !latch.isStopped) {
            stop(hazards.joinToString(", ") { it.name.lowercase().replace('_', ' ') })
        }
        if (nowS >= powerDueS) {
            powerDueS = nowS + REPORT_POWER_EVERY_S
            reading.batteryPercent?.let {
                // no voltage: vehicle battery thresholds must not apply to the phone
                publish(Channels.POWER, BatteryState().sensorName(BATTERY).remaining(it))
            }
        }
        val held = latch.stop().orElse(null)
        snapshot = maker.snapshot(now, hazards, held?.let { "${it.operator()}: ${it.reason()}" })
    }

    /** Triggers an emergency stop that lasts until [clearEmergencyStop]. Thread-safe. */
    fun emergencyStop(reason: String) = stop(reason)

    private fun stop(reason: String) {
        log(LogLevelEnum.WARN, "emergency stop: $reason")
        publish(Channels.EMERGENCY_STOP, EmergencyStop().active(true).operator(NAME).reason(reason))
    }

    /** Clears the active emergency stop; the vehicle stays disarmed. Thread-safe. */
    fun clearEmergencyStop() {
        val stop = newestStop ?: return
        val clears = stop.timestamp().orElse(clock().micros())
        publish(Channels.EMERGENCY_STOP, EmergencyStop().active(false).operator(NAME).clears(clears))
    }

    /** Requests arming or disarming from the Safety Manager. Arming is refused during a hazard. Thread-safe. */
    fun arm(wanted: Boolean): Boolean {
        if (wanted && snapshot.hazards.isNotEmpty()) {
            log(LogLevelEnum.WARN, "not armed: ${snapshot.hazards}")
            return false
        }
        return publish(Channels.ARMING, ArmCommand().requestId(UUID.randomUUID().toString()).arm(wanted).operator(NAME))
    }

    companion object {
        /** Service name and operator name. */
        const val NAME = "Phone"

        /** Name of the phone's battery in messages. */
        const val BATTERY = "PHONE"
    }
}
