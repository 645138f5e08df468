package org.u2sa.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.control.cascade.AllocatingControl;
import org.u2sa.control.fixedwing.CessnaControl;
import org.u2sa.control.ground.AckermannPursuitControl;
import org.u2sa.control.ground.DifferentialDriveControl;
import org.u2sa.control.ground.DifferentialPursuitControl;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

/** One drive, told in several frames: the commands do not depend on the frame of the states. */
class StateFrameTest {
  private static final Geodetic ORIGIN = new Geodetic(-81.0478, 29.1885, 0.0);
  private static final double STEP_S = 0.05;

  static List<Arguments> controls() {
    return List.of(
        control(DifferentialPursuitControl::new, Map.of()),
        control(DifferentialDriveControl::new, Map.of()),
        control(AckermannPursuitControl::new, Map.of()),
        control(AckermannPursuitControl::new, Map.of("STEERING LAW", "STANLEY")),
        control(VelocityControl::new, Map.of()),
        control(
            AllocatingControl::new,
            Map.of("SURGE WEIGHT", 1.0, "YAW WEIGHT", 1.0, "FACES THE WAY", true)));
  }

  private static Arguments control(
      Function<ServiceContext, ControlSystem> control, Map<String, Object> variables) {
    return Arguments.of(control, variables);
  }

  @ParameterizedTest
  @MethodSource("controls")
  void control_statesInEastNorthUp_commandsAsInNorthEastDown(
      Function<ServiceContext, ControlSystem> control, Map<String, Object> variables) {
    List<Double> expected = commands(control, variables, StateFrameTest::local);
    List<Double> commands =
        commands(control, variables, state -> local(state).in(ReferenceFrame.LOCAL_ENU));

    assertSame(commands, expected);
  }

  /** At three degrees of convergence. */
  @ParameterizedTest
  @MethodSource("controls")
  void control_statesOnAGrid_commandsAsInLongitudeAndLatitude(
      Function<ServiceContext, ControlSystem> control, Map<String, Object> variables) {
    List<Double> expected = commands(control, variables, UnaryOperator.identity());
    List<Double> commands =
        commands(control, variables, state -> state.in(ReferenceFrame.utm(16, true)));

    assertSame(commands, expected);
  }

  @Test
  void control_aircraftOnAGrid_commandsAsInLongitudeAndLatitude() {
    List<Double> expected = commands(CessnaControl::new, Map.of(), state -> state.psiDot(-0.2));
    List<Double> commands =
        commands(
            CessnaControl::new,
            Map.of(),
            state -> state.psiDot(-0.2).in(ReferenceFrame.utm(16, true)));

    assertSame(commands, expected);
  }

  private static void assertSame(List<Double> commands, List<Double> expected) {
    assertThat(expected).anySatisfy(percent -> assertThat(Math.abs(percent)).isGreaterThan(1.0));
    assertThat(commands).hasSameSizeAs(expected);
    for (int i = 0; i < commands.size(); i++) {
      assertThat(commands.get(i)).as("command %d", i).isCloseTo(expected.get(i), within(0.1));
    }
  }

  /** All that is commanded on a left-hand bend to a point ahead on the left [%]. */
  private static List<Double> commands(
      Function<ServiceContext, ControlSystem> control,
      Map<String, Object> variables,
      UnaryOperator<StateInformation> told) {
    List<Double> percentages = new ArrayList<>();
    try (ServiceKit kit = new ServiceKit()) {
      variables.forEach(kit::with);
      kit.start(control);
      kit.publish(Channels.ACTUATORS, thruster("PORT", -0.5));
      kit.publish(Channels.ACTUATORS, thruster("STARBOARD", 0.5));
      for (int i = 0; i < 40; i++) {
        StateInformation state = told.apply(onEarth(i));
        kit.publish(Channels.STATE, state);
        kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(6.0, 1.5, 0.0)));
        kit.advance(STEP_S);
      }
      kit.published(Channels.ACTUATION)
          .forEach(command -> percentages.add(((PercentageCommand) command).percentage()));
    }
    return percentages;
  }

  private static ActuatorAnnouncement thruster(String name, double rightM) {
    return new ActuatorAnnouncement()
        .actuatorName(name)
        .minimum(-100.0)
        .maximum(100.0)
        .force(Point.of(10.0, 0.0, 0.0))
        .moment(Point.of(0.0, 0.0, -10.0 * rightM));
  }

  /** Slower than the commands want, so that they learn; without a measured yaw rate. */
  private static StateInformation onEarth(int step) {
    double heading = 1.0 - 0.01 * step;
    Geodetic place = ORIGIN.fromNed(Point.of(0.01 * step, 0.015 * step, 0.0));
    return new StateInformation()
        .x(place.longitudeDeg())
        .y(place.latitudeDeg())
        .z(0.0)
        .xDot(0.36 * Math.sin(heading))
        .yDot(0.36 * Math.cos(heading))
        .zDot(0.0)
        .phi(0.0)
        .theta(0.0)
        .phiDot(0.0)
        .thetaDot(0.0)
        .psi(heading)
        .fluidxDot(40.0);
  }

  private static StateInformation local(StateInformation global) {
    return global.in(ReferenceFrame.LOCAL_NED, ORIGIN);
  }
}
