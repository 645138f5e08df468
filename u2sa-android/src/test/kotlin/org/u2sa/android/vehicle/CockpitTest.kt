package org.u2sa.android.vehicle

import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.data.Offset.offset
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Test
import org.u2sa.android.vehicle.PhoneCondition.Heat
import org.u2sa.android.vehicle.PhoneFailsafe.Hazard
import org.u2sa.interfaces.communication.Channels
import org.u2sa.messages.BatteryState
import org.u2sa.messages.goal.GoalList
import org.u2sa.messages.StateInformation
import org.u2sa.messages.goal.Waypoint
import org.u2sa.messages.safety.ArmingState
import org.u2sa.messages.contract.Condition
import org.u2sa.messages.safety.EmergencyStop
import org.u2sa.messages.safety.FailsafeAction
import org.u2sa.messages.safety.FailsafeState
import org.u2sa.messages.contract.HealthReport
import org.u2sa.messages.contract.ServiceCondition
import org.u2sa.messages.contract.ServiceStatus
import org.u2sa.testkit.ServiceKit

class CockpitTest {
    private val kit = ServiceKit()
    private var phone = PhoneCondition.Reading(80.0, false, Heat.NONE)
    private var board: Boolean? = true
    private val cockpit = kit.start { Cockpit(it, { phone }, { board }, PhoneFailsafe(15.0)) }

    @AfterEach
    fun close() = kit.close()

    private fun drives() {
        kit.publish(Channels.ARMING_STATE, ArmingState().armed(true).reasons(emptyList()))
        isAt(-81.05, 29.19)
    }

    private fun isAt(x: Double, y: Double) =
        kit.publish(Channels.STATE, StateInformation().x(x).y(y).xDot(3.0).yDot(4.0).psi(1.0).xSigma(0.5).ySigma(0.7))

    private fun stops() = kit.published(Channels.EMERGENCY_STOP).filter { it.active() }

    @Test
    fun step_boardLostWhileArmed_stopsOnceAndSaysWhy() {
        drives()
        kit.advance(0.2)
        assertThat(stops()).isEmpty()

        board = false
        kit.advance(0.1)
        assertThat(stops()).hasSize(1)
        assertThat(stops()[0].reason()).isEqualTo("board lost")
        kit.advance(0.1)
        assertThat(cockpit.snapshot.hazards).containsExactly(Hazard.BOARD_LOST)
        assertThat(cockpit.snapshot.emergency).isEqualTo("Phone: board lost")

        kit.advance(2.0)
        assertThat(stops()).hasSize(1)
    }

    @Test
    fun step_boardLostWhileDisarmed_isShownButStopsNothing() {
        isAt(-81.05, 29.19)
        board = false
        kit.advance(0.2)

        assertThat(stops()).isEmpty()
        assertThat(cockpit.snapshot.hazards).containsExactly(Hazard.BOARD_LOST)
    }

    @Test
    fun step_positionLostWhileArmed_stops() {
        drives()
        kit.advance(3.2)

        assertThat(stops().map(EmergencyStop::reason)).containsExactly("position lost")
    }

    @Test
    fun step_phoneTooHotAndEmpty_namesBoth() {
        drives()
        phone = PhoneCondition.Reading(3.0, false, Heat.CRITICAL)
        kit.advance(0.1)

        assertThat(stops().map(EmergencyStop::reason)).containsExactly("battery low, too hot")
    }

    @Test
    fun arm_whileAHazardLasts_isRefused() {
        isAt(-81.05, 29.19)
        board = false
        kit.advance(0.1)

        assertThat(cockpit.arm(true)).isFalse()
        kit.settle()
        assertThat(kit.published(Channels.ARMING)).isEmpty()

        board = true
        kit.advance(0.1)
        assertThat(cockpit.arm(true)).isTrue()
        assertThat(kit.published(Channels.ARMING)).hasSize(1)
    }

    @Test
    fun clearEmergencyStop_stopOfAnother_namesItsTime() {
        kit.publish(Channels.EMERGENCY_STOP, EmergencyStop().active(true).operator("ground").reason("dog"))
        val at = kit.clock().micros()
        kit.advance(1.0)
        assertThat(cockpit.snapshot.emergency).isEqualTo("ground: dog")

        cockpit.clearEmergencyStop()
        kit.advance(0.1)

        val clear = kit.published(Channels.EMERGENCY_STOP).last()
        assertThat(clear.active()).isFalse()
        assertThat(clear.clears()).hasValue(at)
        assertThat(cockpit.snapshot.emergency).isNull()
    }

    @Test
    fun step_everyFiveSeconds_tellsThePhonesChargeWithoutAVoltage() {
        kit.advance(10.1)

        assertThat(kit.published(Channels.POWER)).hasSize(3)
        val power = kit.latest(Channels.POWER).orElseThrow()
        assertThat(power.sensorName()).isEqualTo("PHONE")
        assertThat(power.remaining()).hasValue(80.0)
        assertThat(power.voltage()).isEmpty()
    }

    @Test
    fun snapshot_messagesOfTheVehicle_areAllInIt() {
        val goal = Waypoint().uid("A").x(-81.0).y(29.0).horizontalThreshold(2.0)
        val later = Waypoint().uid("B").x(-81.1).y(29.1).horizontalThreshold(2.0)
        kit.publish(Channels.GOALS, GoalList().goals(listOf(goal)).upcoming(listOf(later)))
        kit.publish(Channels.FAILSAFE, FailsafeState().action(FailsafeAction.HOLD).causes(listOf("position: lost")))
        kit.publish(Channels.HEALTH, HealthReport().serviceName("Good").status(ServiceStatus.RUNNING))
        kit.publish(Channels.HEALTH, HealthReport().serviceName("Bad").status(ServiceStatus.RUNNING))
        kit.publish(
            Channels.CONDITIONS,
            ServiceCondition().serviceName("Bad").condition(Condition.HUNG).reason("no answer").action("restart 1 of 3"),
        )
        kit.publish(Channels.POWER, BatteryState().sensorName("MAIN").voltage(12.1))
        drives()
        kit.advance(0.2)

        val seen = cockpit.snapshot
        assertThat(seen.armed).isTrue()
        assertThat(seen.failsafe).isEqualTo(FailsafeAction.HOLD)
        assertThat(seen.goals.map { it.name to it.current }).containsExactly("A" to true, "B" to false)
        assertThat(seen.services.filterNot { it.healthy })
            .containsExactly(VehicleSnapshot.ServiceLine("Bad", false, "HUNG, no answer, restart 1 of 3"))
        assertThat(seen.services.map { it.name }).contains("Good")
        assertThat(seen.batteries["MAIN"]).isEqualTo(VehicleSnapshot.Battery(12.1, null))
        val motion = requireNotNull(seen.motion)
        assertThat(motion.speedMps).isEqualTo(5.0)
        assertThat(motion.sigmaM).isEqualTo(0.7)
        assertThat(motion.ageS).isCloseTo(0.2, offset(0.05))
    }

    @Test
    fun snapshot_track_growsWithTheWayAndNotWithTime() {
        repeat(5) { isAt(-81.05, 29.19) }
        repeat(10) { isAt(-81.05 + 1e-5 * it, 29.19) } // about a metre each
        kit.advance(0.1)

        assertThat(cockpit.snapshot.track).hasSize(10)
    }

    @Test
    fun snapshot_stateWithoutAPlace_isNoPosition() {
        kit.publish(Channels.STATE, StateInformation().psi(1.0))
        kit.advance(0.1)

        assertThat(cockpit.snapshot.motion).isNull()
        assertThat(cockpit.snapshot.hazards).contains(Hazard.POSITION_LOST)
    }
}
