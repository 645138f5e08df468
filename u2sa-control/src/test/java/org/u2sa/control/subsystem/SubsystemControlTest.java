package org.u2sa.control.subsystem;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.testkit.ServiceKit;

/** Gimbals and arms follow the navigation points of their subsystems. */
class SubsystemControlTest {
  private static final double NEAR = 1.0e-6;
  private static final double DEG = Math.PI / 180.0;

  private final ServiceKit kit = new ServiceKit().with("BLEND TIME", 0.0);

  @AfterEach
  void end() {
    kit.close();
  }

  private void announce(String joint, double minimum, double maximum, double fullRad) {
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName(joint)
            .minimum(minimum)
            .maximum(maximum)
            .fullAngle(fullRad)
            .commandTypes(List.of("AngleCommand")));
  }

  private void gimbal() {
    kit.start(GimbalControl::new);
    announce("PAN", -100.0, 100.0, Math.PI);
    announce("TILT", -100.0, 50.0, Math.PI / 2.0);
  }

  private void arm() {
    kit.start(ManipulatorControl::new);
    announce("ARM BASE", -100.0, 100.0, Math.PI);
    announce("SHOULDER", -100.0, 100.0, Math.PI);
    announce("ELBOW", -100.0, 100.0, Math.PI);
  }

  private StateInformation state(double rollRad, double pitchRad, double headingRad) {
    StateInformation state =
        new StateInformation().x(8.5).y(47.4).z(100.0).phi(rollRad).theta(pitchRad).psi(headingRad);
    state.timestamp(kit.clock().micros());
    return state;
  }

  private void target(String subsystem, Point body) {
    NavigationPoint point = NavigationPoint.at(body).subsystem(subsystem);
    point.timestamp(kit.clock().micros());
    kit.publish(Channels.NAVIGATION, point);
    kit.advance(0.02);
  }

  private void see(String subsystem, Point body) {
    kit.publish(Channels.STATE, state(0.0, 0.0, 0.0));
    target(subsystem, body);
    kit.publish(Channels.STATE, state(0.0, 0.0, 0.0));
  }

  private OptionalDouble angle(String joint) {
    Optional<ActuatorCommand> last =
        kit.published(Channels.ACTUATION).stream()
            .filter(each -> each.actuatorName().equals(joint))
            .reduce((first, second) -> second);
    return last.isPresent()
        ? OptionalDouble.of(((AngleCommand) last.get()).angle())
        : OptionalDouble.empty();
  }

  private void assertAngle(String joint, double rad) {
    assertThat(angle(joint).orElseThrow()).as(joint).isCloseTo(rad, within(NEAR));
  }

  @ParameterizedTest
  @CsvSource({
    "10, 0, 0, 0, 0",
    "0, 10, 0, 90, 0",
    "-10, -10, 0, -135, 0",
    "10, 0, -10, 0, 45",
    "10, 0, 10, 0, -45",
    "10, 0, -1000, 0, 45"
  })
  void gimbal_point_isFaced(double x, double y, double down, double panDeg, double tiltDeg) {
    gimbal();
    see("GIMBAL", Point.of(x, y, down));
    assertAngle("PAN", panDeg * DEG);
    assertAngle("TILT", tiltDeg * DEG); // the last one is cut off at 50 % of 90 deg
  }

  @Test
  void gimbal_vehicleTurnedAndRolledSince_staysOnThePoint() {
    gimbal();
    kit.publish(Channels.STATE, state(0.0, 0.0, 0.0));
    target("GIMBAL", Point.of(10.0, 0.0, 0.0)); // in the north
    kit.publish(Channels.STATE, state(0.0, 0.0, 30.0 * DEG)); // now to the left
    assertAngle("PAN", 30.0 * DEG);
    kit.advance(0.02);
    kit.publish(Channels.STATE, state(0.0, 20.0 * DEG, 0.0)); // nose up
    assertAngle("TILT", -20.0 * DEG);
  }

  @Test
  void gimbal_levelledItself_doesNotCompensatePitchTwice() {
    kit.with("LEVELLED", true);
    gimbal();
    kit.publish(Channels.STATE, state(0.0, 20.0 * DEG, 0.0));
    target("GIMBAL", Point.of(10.0 * Math.cos(20.0 * DEG), 0.0, 10.0 * Math.sin(20.0 * DEG)));
    kit.publish(Channels.STATE, state(0.0, 20.0 * DEG, 0.0));
    assertAngle("TILT", 0.0);
  }

  @Test
  void gimbal_mountedOffTheReferencePoint_facesFromThere() {
    kit.with("MOUNTED X", 2.0).with("MOUNTED Y", 1.0).with("MOUNTED YAW", 90.0 * DEG);
    gimbal();
    see("GIMBAL", Point.of(2.0, 5.0, 0.0)); // straight to the left of it
    assertAngle("PAN", 0.0);
  }

  @Test
  void gimbal_otherSubsystemsPoint_isIgnored() {
    gimbal();
    see("VEHICLE", Point.of(0.0, 10.0, 0.0));
    assertThat(angle("PAN")).isEmpty();
  }

  @Test
  void gimbal_pointsEnd_holdsOrReturns() {
    gimbal();
    see("GIMBAL", Point.of(0.0, 10.0, 0.0));
    kit.advance(3.0);
    kit.publish(Channels.STATE, state(0.0, 0.0, 0.0));
    assertAngle("PAN", 90.0 * DEG);
  }

  @Test
  void gimbal_pointsEndWithNeutral_commandsZero() {
    kit.with("WITHOUT POINT", "NEUTRAL");
    gimbal();
    see("GIMBAL", Point.of(0.0, 10.0, 0.0));
    kit.advance(3.0);
    kit.publish(Channels.STATE, state(0.0, 0.0, 0.0));
    assertAngle("PAN", 0.0);
  }

  @Test
  void gimbal_withoutStates_facesThePointAsSeen() {
    gimbal();
    target("GIMBAL", Point.of(0.0, -10.0, 0.0));
    assertAngle("PAN", -90.0 * DEG);
  }

  @Test
  void gimbal_axesNotAnnounced_commandsNothing() {
    kit.start(GimbalControl::new);
    see("GIMBAL", Point.of(0.0, 10.0, 0.0));
    assertThat(kit.published(Channels.ACTUATION)).isEmpty();
  }

  /** Where the tip is: forward, left, down of the arm's base. */
  private Point tip(double upper, double fore) {
    double base = angle("ARM BASE").orElseThrow();
    double shoulder = angle("SHOULDER").orElseThrow();
    double both = shoulder + angle("ELBOW").orElseThrow();
    double out = upper * Math.cos(shoulder) + fore * Math.cos(both);
    double up = upper * Math.sin(shoulder) + fore * Math.sin(both);
    return Point.of(out * Math.cos(base), out * Math.sin(base), -up);
  }

  @ParameterizedTest
  @CsvSource({"0.4, 0.1, 0.2", "0.2, -0.3, -0.1", "-0.1, 0.2, 0.0", "0.05, 0, 0.4"})
  void arm_pointInReach_isReachedWithTheElbowUp(double x, double y, double down) {
    kit.with("UPPER ARM", 0.4).with("FOREARM", 0.3);
    arm();
    see("ARM", Point.of(x, y, down));
    assertThat(tip(0.4, 0.3).minus(Point.of(x, y, down)).distance()).isLessThan(NEAR);
    assertThat(angle("ELBOW").orElseThrow()).isNegative();
  }

  @Test
  void arm_pointTooFar_isPointedAtStretchedOut() {
    arm();
    see("ARM", Point.of(3.0, 4.0, 0.0));
    assertThat(tip(0.3, 0.3).minus(Point.of(0.36, 0.48, 0.0)).distance()).isLessThan(NEAR);
  }
}
