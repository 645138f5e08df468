package org.u2sa.control.subsystem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** A dropper and a launcher. */
class ReleaseControlTest {
  @AutoClose
  private final ServiceKit kit =
      new ServiceKit()
          .with("ACTUATORS", "DROPPER, LAUNCHER")
          .with("STALE AFTER", 0.3)
          .with("BLEND TIME", 0.0);

  @BeforeEach
  void start() {
    kit.start(ReleaseControl::new);
  }

  private void state() {
    kit.advance(0.1);
    StateInformation state =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).psi(0.0);
    state.timestamp(Clock.micros(kit.nowS()));
    kit.publish(Channels.STATE, state);
  }

  private void point(String subsystem) {
    NavigationPoint point = NavigationPoint.at(Point.of(1.0, 0.0, 0.0)).subsystem(subsystem);
    point.timestamp(Clock.micros(kit.nowS()));
    kit.publish(Channels.NAVIGATION, point);
  }

  private double percent(String actuator) {
    return kit.published(Channels.ACTUATION).stream()
        .filter(command -> command.actuatorName().equals(actuator))
        .map(command -> ((PercentageCommand) command).percentage())
        .reduce((before, last) -> last)
        .orElseThrow();
  }

  @Test
  void control_pointForTheDropper_releasesItAlone() {
    state();
    point("DROPPER");
    state();

    assertThat(percent("DROPPER")).isEqualTo(100.0);
    assertThat(percent("LAUNCHER")).isZero();
  }

  @Test
  void control_noPointForAWhile_commandsTheSafePosition() {
    state();
    point("DROPPER");
    state();
    kit.advance(0.5);
    state();

    assertThat(percent("DROPPER")).isZero();
  }

  @Test
  void control_pointForTheVehicle_releasesNothing() {
    state();
    point("VEHICLE");
    state();

    assertThat(percent("DROPPER")).isZero();
  }
}
