package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.sim.ioio.PulseTrain;

/** When the motors get which pulses: with the unmodified library and a simulated board. */
class IoioServiceTest {
  private final BoardKit on = new BoardKit();

  @AfterEach
  void close() {
    on.close();
  }

  @Test
  void start_nothingCommanded_isNeutralAndAnnounced() {
    on.start();
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
    assertThat(on.kit.published(Channels.ACTUATORS))
        .extracting(ActuatorAnnouncement::actuatorName)
        .contains("LEFT MOTOR", "RIGHT MOTOR");
    assertThat(on.bench.level(0)).as("the LED is lit: it obeys").isFalse();
    assertThat(on.lastError()).isEmpty();
  }

  @Test
  void callback_percentages_becomePulsesWithSlew() {
    on.start();
    on.command("LEFT MOTOR", 100.0);
    on.command("RIGHT MOTOR", -50.0);
    on.kit.advance(0.05);
    assertThat(on.bench.width(BoardKit.LEFT)).isBetween(1.55e-3, 1.65e-3); // 400 %/s
    on.drive(100.0, -50.0, 0.5);
    on.expectWidths(2.0e-3, 1.25e-3);
    on.drive(0.0, 0.0, 0.5);
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
  }

  @Test
  void callback_commandsEnd_neutralAfterTheExpiry() {
    on.start();
    on.drive(60.0, 60.0, 0.5);
    on.kit.advance(0.6);
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
  }

  @Test
  void callback_oneMotorIsNotCommanded_bothAreNeutral() {
    on.start();
    for (int i = 0; i < 10; i++) {
      on.kit.publish(
          Channels.ACTUATION, new PercentageCommand().actuatorName("LEFT MOTOR").percentage(80.0));
      on.kit.advance(0.1);
    }
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
  }

  @Test
  void callback_emergencyStop_isNeutralWithoutAStepAndStaysSo() {
    on.start();
    on.drive(100.0, 100.0, 0.5);
    on.kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).operator("test"));
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S); // no time has passed
    int from = on.bench.history(BoardKit.LEFT, 0).size();
    on.drive(100.0, 100.0, 1.0);
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
    assertThat(on.bench.history(BoardKit.LEFT, from)).as("no pulse of another width").isEmpty();
  }

  @Test
  void callback_armingRequired_movesOnlyWhileArmed() {
    on.kit.with("REQUIRES ARMING", true);
    on.start();
    on.drive(50.0, 50.0, 0.5);
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
    on.kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    on.drive(50.0, 50.0, 0.5);
    on.expectWidths(1.75e-3, 1.75e-3);
    on.kit.publish(Channels.ARMING_STATE, new ArmingState().armed(false).reasons(List.of("test")));
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
  }

  @Test
  void swap_driving_goesOnWithTheCommandAsSoonAsItHasTheBoardAndNeverBackwards() {
    IoioService before = on.start();
    on.command("LEFT MOTOR", 60.0, 3.0);
    on.command("RIGHT MOTOR", 60.0, 3.0);
    on.kit.advance(0.5);
    on.expectWidths(1.8e-3, 1.8e-3);
    int from = on.bench.history(BoardKit.LEFT, 0).size();

    on.kit.swap(
        before, context -> new IoioService(context, BoardConnectorTest.connection(on.board)));
    on.kit.advance(1.5);

    on.expectWidths(1.8e-3, 1.8e-3);
    assertThat(on.bench.history(BoardKit.LEFT, from))
        .allSatisfy(
            pulses ->
                assertThat(pulses.widthS())
                    .satisfiesAnyOf(
                        width -> assertThat(width).as("no pulses").isZero(),
                        width -> assertThat(width).isBetween(1.4999e-3, 1.8001e-3)));
    on.kit.advance(1.5);
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S); // 3 s after the command
  }

  @Test
  void step_radioAtManual_isNeutralAndBackAtAutomatic() {
    on.start();
    on.drive(50.0, 50.0, 0.5);
    on.bench.pulses(35, 1.1e-3);
    on.drive(50.0, 50.0, 0.2);
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
    assertThat(on.kit.latest(Channels.ACTUATORS).orElseThrow().withheld()).isTrue();
    on.bench.pulses(35, 1.9e-3);
    on.drive(50.0, 50.0, 0.5);
    assertThat(on.kit.latest(Channels.ACTUATORS).orElseThrow().withheld()).isFalse();
    on.expectWidths(1.75e-3, 1.75e-3);
    on.bench.pulses(35, 0.0);
    on.drive(50.0, 50.0, 0.5);
    on.expectWidths(BoardKit.NEUTRAL_S, BoardKit.NEUTRAL_S);
    assertThat(on.kit.log("IoioService"))
        .anySatisfy(line -> assertThat(line).contains("radio: MANUAL"))
        .anySatisfy(line -> assertThat(line).contains("the radio is lost: commands are withheld"));
  }

  @Test
  void step_powerCycle_isSaidAndBackAtNeutralWithinTwoSeconds() {
    on.start();
    on.drive(100.0, 100.0, 0.5);
    on.board.power(false);
    assertThat(on.bench.width(BoardKit.LEFT)).isZero();
    on.drive(100.0, 100.0, 0.5);
    assertThat(on.lastError().orElseThrow())
        .isEqualTo("the IOIO at this process is lost: the board has no power");
    on.board.power(true);
    int from = on.bench.history(BoardKit.LEFT, 0).size();
    on.drive(100.0, 100.0, 2.0);
    on.expectWidths(2.0e-3, 2.0e-3);
    double first =
        on.bench.history(BoardKit.LEFT, from).stream()
            .mapToDouble(PulseTrain::widthS)
            .filter(width -> width > 0.0)
            .findFirst()
            .orElseThrow();
    assertThat(first)
        .as("the first pulse")
        .isCloseTo(BoardKit.NEUTRAL_S, within(BoardKit.RESOLUTION_S));
  }

  /** What is left of an actuator, by its newest announcement [%]. */
  private double left(String actuator) {
    return on.kit.published(Channels.ACTUATORS).stream()
        .filter(each -> each.actuatorName().equals(actuator))
        .reduce((first, second) -> second)
        .orElseThrow()
        .available()
        .orElse(100.0);
  }

  @Test
  void step_powerCycle_bothMotorsAreAnnouncedAsLostAndThenAsBack() {
    on.start();
    assertThat(left("LEFT MOTOR")).isEqualTo(100.0);
    on.board.power(false);
    on.kit.advance(0.1);
    assertThat(left("LEFT MOTOR")).isZero();
    assertThat(left("RIGHT MOTOR")).isZero();
    on.board.power(true);
    on.kit.advance(2.0);
    assertThat(left("LEFT MOTOR")).isEqualTo(100.0);
    assertThat(left("RIGHT MOTOR")).isEqualTo(100.0);
  }

  @Test
  void kill_connected_withdrawsBothMotors() {
    IoioService service = on.start();
    service.kill();
    assertThat(left("LEFT MOTOR")).isZero();
    assertThat(left("RIGHT MOTOR")).isZero();
  }

  @Test
  void release_moving_neutralComesBeforeTheEnd() {
    IoioService service = on.start();
    on.drive(100.0, 100.0, 0.5);
    service.kill();
    List<PulseTrain> all = on.bench.history(BoardKit.LEFT, 0);
    assertThat(all.get(all.size() - 1)).isEqualTo(PulseTrain.NONE);
    assertThat(all.get(all.size() - 2).widthS())
        .isCloseTo(BoardKit.NEUTRAL_S, within(BoardKit.RESOLUTION_S));
  }

  @Test
  void step_ackermann_hasItsNames() {
    on.kit.with("ACTUATORS", "THROTTLE=10, STEERING=11");
    on.start();
    on.kit.publish(
        Channels.ACTUATION, new PercentageCommand().actuatorName("THROTTLE").percentage(0.0));
    on.kit.publish(
        Channels.ACTUATION, new PercentageCommand().actuatorName("STEERING").percentage(50.0));
    on.kit.advance(0.3);
    on.expectWidths(BoardKit.NEUTRAL_S, 1.75e-3);
  }

  @Test
  void step_servoWithAnAngleAndAnEffect_isAnnouncedInNumbersAndTakesAngles() {
    on.kit.with("ACTUATORS", "THROTTLE=10, STEERING=11");
    on.kit.with("STEERING FULL ANGLE", 30.0);
    on.kit.with("STEERING EFFECT", "wrench 0 5 0 0 0 2");
    on.start();
    ActuatorAnnouncement steering =
        on.kit.published(Channels.ACTUATORS).stream()
            .filter(each -> each.actuatorName().equals("STEERING"))
            .findFirst()
            .orElseThrow();
    assertThat(steering.commandTypes()).contains("AngleCommand");
    assertThat(steering.fullAngle().orElseThrow()).isCloseTo(Math.toRadians(30.0), within(1e-12));
    assertThat(steering.moment()).contains(Point.of(0.0, 0.0, 2.0));

    on.kit.publish(Channels.ACTUATION, PercentageCommand.of("THROTTLE", 0.0));
    on.kit.publish(Channels.ACTUATION, AngleCommand.of("STEERING", Math.toRadians(-15.0)));
    on.kit.advance(0.3);
    on.expectWidths(BoardKit.NEUTRAL_S, 1.25e-3);
  }
}
