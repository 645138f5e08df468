package org.u2sa.android.vehicle

import java.util.UUID
import org.u2sa.android.board.BoardCondition
import org.u2sa.interfaces.communication.Channels
import org.u2sa.interfaces.log.LogLevelEnum
import org.u2sa.messages.BatteryState
import org.u2sa.messages.contract.ArmCommand
import org.u2sa.messages.contract.EmergencyStop
import org.u2sa.messages.schema.U2SAData
import org.u2sa.service.EmergencyLatch
import org.u2sa.service.PeriodicService
import org.u2sa.service.ServiceContext
import org.u2sa.service.ServiceRole

private const val LOOKS_PER_S = 10.0
private const val REPORT_POWER_EVERY_S = 5.0

/**
 * The phone's place in the vehicle: shows what the vehicle says, gives the operator's orders, and stops the vehicle when the
 * phone cannot carry it any longer ([PhoneFailsafe]). In: state, goals, health, conditions, failsafe, arming-state,
 * emergency-stop, power. Out: emergency-stop, arming, and power for the phone's own battery. Thesis 4.6.
 *
 * Hazards stop an armed vehicle once, by an emergency stop that only an operator lifts; one that stands is not armed while they
 * last.
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

    /** The newest picture; from any thread. */
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
                // no voltage: a level that is meant for the vehicle's battery would take the phone's for an empty one
                publish(Channels.POWER, BatteryState().sensorName(BATTERY).remaining(it))
            }
        }
        val held = latch.stop().orElse(null)
        snapshot = maker.snapshot(now, hazards, held?.let { "${it.operator()}: ${it.reason()}" })
    }

    /** Stops everything that moves until [clearEmergencyStop]. From any thread. */
    fun emergencyStop(reason: String) = stop(reason)

    private fun stop(reason: String) {
        log(LogLevelEnum.WARN, "emergency stop: $reason")
        publish(Channels.EMERGENCY_STOP, EmergencyStop().active(true).operator(NAME).reason(reason))
    }

    /** Lifts the emergency stop that is known here; the vehicle stays disarmed. From any thread. */
    fun clearEmergencyStop() {
        val stop = newestStop ?: return
        val clears = stop.timestamp().orElse(clock().micros())
        publish(Channels.EMERGENCY_STOP, EmergencyStop().active(false).operator(NAME).clears(clears))
    }

    /** Asks the Safety Manager to let the vehicle move, or no longer. Refused while a hazard lasts. From any thread. */
    fun arm(wanted: Boolean): Boolean {
        if (wanted && snapshot.hazards.isNotEmpty()) {
            log(LogLevelEnum.WARN, "not armed: ${snapshot.hazards}")
            return false
        }
        return publish(Channels.ARMING, ArmCommand().requestId(UUID.randomUUID().toString()).arm(wanted).operator(NAME))
    }

    companion object {
        /** Its name among the services, and as the operator. */
        const val NAME = "Phone"

        /** The phone's battery in messages. */
        const val BATTERY = "PHONE"
    }
}
