package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.common.AdsbVehicle;
import io.dronefleet.mavlink.common.ObstacleDistance;
import io.dronefleet.mavlink.common.ServoOutputRaw;
import io.dronefleet.mavlink.common.VfrHud;
import io.dronefleet.mavlink.common.WindCov;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.MovingSphere;

/** What a station is told about obstacles, traffic, wind and outputs. */
class StationSurroundingsTest {
  private final BridgeKit kit = BridgeKit.rover().ready();

  private void sees(U2SAData message) {
    message.freeze();
    kit.vehicle.surroundings.take(message);
    kit.advance(1.0);
  }

  @Test
  void obstacles_beamsLeftAheadAndRight_areClockwiseFromAhead() {
    sees(
        new RangeScan()
            .sensorName("Laser")
            .minRange(0.1)
            .maxRange(10.0)
            .beams(
                -Math.PI / 2.0, // to the right
                Math.PI / 2.0,
                List.of(OptionalDouble.of(2.0), OptionalDouble.of(3.0), OptionalDouble.empty())));

    List<Integer> distances = last(ObstacleDistance.class).distances();
    assertThat(distances.get(0)).isEqualTo(300);
    assertThat(distances.get(18)).as("right").isEqualTo(200);
    assertThat(distances.get(54)).as("left: seen, nothing there").isEqualTo(1001);
    assertThat(distances.get(36)).as("behind: not seen").isEqualTo(65_535);
  }

  @Test
  void traffic_withAnAddress_isToldInTurn() {
    sees(new ObjectList().objects(List.of(aircraft("4B1803"), aircraft("00A2F1"), boat())));
    kit.advance(1.0);

    List<AdsbVehicle> told = kit.received(AdsbVehicle.class);
    assertThat(told).extracting(AdsbVehicle::icaoAddress).contains(0x4B1803L, 0xA2F1L);
    assertThat(told).hasSizeGreaterThan(4);
    assertThat(told.get(0).lat()).isEqualTo(540_100_000);
    assertThat(told.get(0).altitude()).isEqualTo(300_000);
    assertThat(told.get(0).heading()).as("east").isEqualTo(9000);
    assertThat(told.get(0).horVelocity()).isEqualTo(5000);
  }

  private static MovingSphere aircraft(String address) {
    MovingSphere sphere = new MovingSphere().radius(150.0);
    sphere.uid("traffic " + address).objectType("aircraft").x(10.0).y(54.01).z(300.0);
    sphere.motion().velocity(Point.of(50.0, 0.0, 0.0));
    return sphere;
  }

  private static MovingSphere boat() {
    MovingSphere sphere = new MovingSphere().radius(50.0);
    sphere.uid("traffic 211000").objectType("ship").x(10.0).y(54.0).z(0.0);
    return sphere;
  }

  @Test
  void wind_motionOverGroundLessThatThroughTheAir_isThatOfTheAir() {
    kit.says(
        new StateInformation()
            .x(10.0)
            .y(54.0)
            .z(100.0)
            .xDot(30.0)
            .yDot(5.0)
            .psi(Math.PI / 2.0)
            .fluidxDot(25.0)
            .fluidyDot(0.0));
    kit.advance(1.1);

    WindCov wind = last(WindCov.class);
    assertThat(wind.windX()).as("north").isCloseTo(5.0f, within(0.01f));
    assertThat(wind.windY()).as("east").isCloseTo(5.0f, within(0.01f));
    assertThat(wind.windZ()).isNaN();
  }

  @Test
  void outputs_commands_arePulsesByName() {
    sees(PercentageCommand.of("RIGHT MOTOR", 50.0));
    sees(PercentageCommand.of("LEFT MOTOR", -100.0));

    ServoOutputRaw outputs = last(ServoOutputRaw.class);
    assertThat(outputs.servo1Raw()).isEqualTo(1000);
    assertThat(outputs.servo2Raw()).isEqualTo(1750);
    assertThat(outputs.servo3Raw()).isZero();
  }

  @ParameterizedTest
  @CsvSource({"THROTTLE, 62.4, 62", "THROTTLE, -5, 0", "THROTTLE, 100, 100", "LEFT MOTOR, 50, 0"})
  void throttle_command_isToldIfTheActuatorIsTheThrottle(
      String actuator, double percent, int told) {
    kit.says(new StateInformation().x(10.0).y(54.0).z(100.0).psi(0.0));
    sees(PercentageCommand.of(actuator, percent));

    assertThat(last(VfrHud.class).throttle()).isEqualTo(told);
  }

  @Test
  void throttle_commandOfLongAgo_isNoLongerTold() {
    sees(PercentageCommand.of("THROTTLE", 62.0));
    kit.advance(1.5);
    kit.says(new StateInformation().x(10.0).y(54.0).z(100.0).psi(0.0));
    kit.advance(1.0);

    assertThat(last(VfrHud.class).throttle()).isZero();
  }

  private <T> T last(Class<T> type) {
    List<T> all = kit.received(type);
    return all.get(all.size() - 1);
  }
}
