package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/**
 * The unit of every field that is read, by frames that are put together byte for byte from
 * MAVLink's definition (common.xml), not by a library that may share the driver's mistake.
 */
class MavlinkUnitsTest {
  private static final int SYSTEM = 7;

  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();

  @BeforeEach
  void start() {
    kit.start(context -> new MavlinkAutopilot(context, link));
    say(new MavlinkFrame(0, 50, 9).i8(4, 10).i8(5, 3).i8(6, 128).i8(7, 4).i8(8, 3)); // HEARTBEAT
  }

  @AfterEach
  void end() {
    kit.close();
  }

  private void say(MavlinkFrame frame) {
    link.fromDevice(frame.from(SYSTEM));
    kit.advance(0.1);
  }

  private BatteryState battery() {
    return kit.latest(Channels.POWER).orElseThrow();
  }

  private StateInformation state() {
    return kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  private static void assertNumber(OptionalDouble number, double expected) {
    assertThat(number.getAsDouble()).isCloseTo(expected, within(1.0e-9 * Math.abs(expected)));
  }

  /** voltage_battery 14 [mV], current_battery 16 [cA], battery_remaining 30 [%]. */
  @Test
  void sysStatus_millivoltsCentiampsPercent_areVoltsAmpsPercent() {
    say(new MavlinkFrame(1, 124, 31).i16(14, 15_200).i16(16, 1_234).i8(30, 64));
    assertNumber(battery().voltage(), 15.2);
    assertNumber(battery().current(), 12.34);
    assertNumber(battery().remaining(), 64.0);
  }

  /** voltages[10] from 10 [mV], current_battery 30 [cA], id 32, battery_remaining 35 [%]. */
  @Test
  void batteryStatus_millivoltsCentiampsPercent_areVoltsAmpsPercent() {
    MavlinkFrame frame = new MavlinkFrame(147, 154, 54).i16(30, 321).i8(32, 2).i8(35, 55);
    for (int cell = 0; cell < 10; cell++) {
      frame.i16(10 + 2 * cell, cell < 3 ? 4_000 + cell : 0xFFFF);
    }
    say(frame.i16(41, 4_100)); // voltages_ext[0], cell 11
    assertThat(battery().sensorName()).isEqualTo("MavlinkAutopilot 2");
    assertNumber(battery().voltage(), 16.103);
    assertNumber(battery().current(), 3.21);
    assertNumber(battery().remaining(), 55.0);
  }

  /** -1: not known. */
  @Test
  void sysStatus_unknownCurrentAndCharge_areAbsent() {
    say(new MavlinkFrame(1, 124, 31).i16(14, 15_200).i16(16, -1).i8(30, -1));
    assertThat(battery().current()).isEmpty();
    assertThat(battery().remaining()).isEmpty();
  }

  /** lat 4, lon 8 [1e-7 deg], alt 12 [mm], vx 20, vy 22, vz 24 [cm/s: north, east, down]. */
  @Test
  void globalPositionInt_integers_areDegreesMetresAndMetresPerSecond() {
    say(
        new MavlinkFrame(33, 104, 28)
            .i32(4, 473_977_420)
            .i32(8, -85_455_940)
            .i32(12, 488_123)
            .i32(16, 20_000) // above ground: not used
            .i16(20, 110)
            .i16(22, -220)
            .i16(24, 57)
            .i16(26, 9_000)); // heading: ATTITUDE's is used
    assertNumber(state().y(), 47.397742);
    assertNumber(state().x(), -8.545594);
    assertNumber(state().z(), 488.123);
    assertNumber(state().yDot(), 1.10);
    assertNumber(state().xDot(), -2.20);
    assertNumber(state().zDot(), -0.57);
    assertThat(state().xSigma()).isEmpty();
    assertThat(state().psi()).as("measured apart").isEmpty();
    assertThat(state().referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
  }

  /** fix_type 28, h_acc 34, v_acc 38 [mm], vel_acc 42 [mm/s]. */
  @Test
  void gpsRawInt_millimetres_areMetresAlongEachAxis() {
    say(new MavlinkFrame(24, 24, 52).i8(28, 3).i32(34, 1_414).i32(38, 2_500).i32(42, 350));
    say(new MavlinkFrame(33, 104, 28).i32(4, 473_977_420).i32(8, 85_455_940));
    assertNumber(state().xSigma(), 1.414 / Math.sqrt(2.0));
    assertNumber(state().ySigma(), 1.414 / Math.sqrt(2.0));
    assertNumber(state().zSigma(), 2.5);
    assertNumber(state().xDotSigma(), 0.35);
    assertNumber(state().yDotSigma(), 0.35);
    assertNumber(state().zDotSigma(), 0.35);
  }

  /** roll 4, pitch 8, yaw 12 [rad], rollspeed 16, pitchspeed 20, yawspeed 24 [rad/s]. */
  @Test
  void attitude_radians_areRadians() {
    say(new MavlinkFrame(30, 39, 28).f32(4, 0.25).f32(12, -0.5).f32(16, 0.125).f32(20, 0.5));
    assertThat(state().x()).as("measured apart").isEmpty();
    assertThat(state().referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertNumber(state().phi(), 0.25);
    assertThat(state().theta()).hasValue(0.0);
    assertNumber(state().psi(), 2.0 * Math.PI - 0.5);
    assertNumber(state().phiDot(), 0.125); // level: p and φ̇ are the same
    assertNumber(state().thetaDot(), 0.5 * Math.cos(0.25)); // θ̇ = q cos φ
    assertThat(state().number(StateField.PSI_DOT).getAsDouble())
        .isCloseTo(0.5 * Math.sin(0.25), within(1.0e-9)); // ψ̇ = q sin φ / cos θ
  }
}
