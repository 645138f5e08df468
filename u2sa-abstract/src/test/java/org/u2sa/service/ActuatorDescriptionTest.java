package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.command.ForceCommand;
import org.u2sa.messages.command.SpeedCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.testkit.ServiceKit;

class ActuatorDescriptionTest {
  private static final double TINY = 1e-9;

  @AutoClose private final ServiceKit kit = new ServiceKit();

  /** An actuator that remembers what it did. */
  private static final class Thruster extends Actuator {
    private double percent;

    Thruster(ServiceContext context) {
      super(context, "Thruster");
    }

    @Override
    protected void actuate(double percentage) {
      percent = percentage;
    }

    @Override
    protected void neutral() {
      percent = 0.0;
    }

    void derate(double left) {
      available(left);
    }
  }

  private Thruster start() {
    return kit.with("RENEWAL", 0.25).start(Thruster::new);
  }

  private ActuatorAnnouncement announced() {
    return kit.latest(Channels.ACTUATORS).orElseThrow();
  }

  @Test
  void announce_thrustAtAPlace_isForceAndMomentBothWays() {
    kit.with("EFFECT", "thrust 40 / 30 at 0.5 -0.25 0.125 towards 3 4 0");
    start();

    assertNear(announced().force().orElseThrow(), 24.0, 32.0, 0.0);
    assertNear(announced().moment().orElseThrow(), -4.0, 3.0, 22.0); // r × F
    assertNear(announced().reverseForce().orElseThrow(), -18.0, -24.0, 0.0);
    assertNear(announced().reverseMoment().orElseThrow(), 3.0, -2.25, -16.5);
    assertThat(announced().commandTypes()).containsExactly("ForceCommand");
  }

  private static void assertNear(Point point, double x, double y, double z) {
    assertThat(point.x()).isCloseTo(x, within(TINY));
    assertThat(point.y()).isCloseTo(y, within(TINY));
    assertThat(point.z()).isCloseTo(z, within(TINY));
  }

  @Test
  void announce_wrench_isWhatWasWritten() {
    kit.with("EFFECT", "wrench 0 0 0 900 0 -40");
    start();

    assertNear(announced().moment().orElseThrow(), 900.0, 0.0, -40.0);
    assertThat(announced().reverseForce()).isEmpty();
    assertThat(announced().commandTypes()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "push 3",
        "thrust",
        "thrust 0 at 0 0 0 towards 1 0 0",
        "thrust 4 / at 0 0 0 towards 1 0 0",
        "thrust 4 at 0 0 towards 1 0 0",
        "thrust 4 at 0 0 0 towards 0 0 0",
        "thrust 4 at 0 0 0 towards 1 0 0 0",
        "thrust 4 at 0 0 NaN towards 1 0 0",
        "wrench 1 2 3 4 5",
        "wrench 1 2 3 4 5 6 / 1"
      })
  void start_effectThatCannotBeRead_isRefusedWithTextAndForms(String effect) {
    kit.with("EFFECT", effect);

    assertThatThrownBy(this::start)
        .hasMessageContaining("effect \"" + effect)
        .hasMessageContaining("expected \"thrust N");
  }

  @ParameterizedTest
  @CsvSource({"0.25,50", "-0.5,-100"})
  void angleCommand_toAServoWithFullAngle_isItsShare(double share, double percent) {
    kit.with("FULL ANGLE", Math.toDegrees(0.5));
    Thruster servo = start();

    kit.publish(Channels.ACTUATION, AngleCommand.of("Thruster", share));

    assertThat(servo.percent).isCloseTo(percent, within(TINY));
  }

  @Test
  void speedCommand_toAMotorWithFullSpeed_isItsShareAndKeptAsSent() {
    kit.with("FULL SPEED", 20.0);
    Thruster motor = start();

    kit.publish(Channels.ACTUATION, SpeedCommand.of("Thruster", -5.0));

    assertThat(motor.percent).isEqualTo(-25.0);
    assertThat(motor.command()).containsInstanceOf(SpeedCommand.class);
  }

  @Test
  void forceCommand_toAPropeller_goesThroughDeadbandAndSquare() {
    kit.with("EFFECT", "thrust 40 / 30 at 0 0 0 towards 1 0 0")
        .with("EFFECT EXPONENT", 2.0)
        .with("DEADBAND", 10.0);
    Thruster propeller = start();

    kit.publish(Channels.ACTUATION, ForceCommand.of("Thruster", 10.0));
    assertThat(propeller.percent).isCloseTo(10.0 + 90.0 * 0.5, within(TINY));

    kit.publish(Channels.ACTUATION, ForceCommand.of("Thruster", -7.5));
    assertThat(propeller.percent).isCloseTo(-55.0, within(TINY));
  }

  @Test
  void command_ofAKindThatIsNotTaken_isRefusedSaidAndLeavesItNeutral() {
    kit.with("FULL ANGLE", 30.0);
    Thruster servo = start();
    ActuatorCommand speed = SpeedCommand.of("Thruster", 5.0);

    kit.publish(Channels.ACTUATION, speed);
    kit.advance(1.0);

    assertThat(servo.percent).isZero();
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().commandsRefused()).hasValue(1);
    assertThat(kit.log("Thruster"))
        .anySatisfy(line -> assertThat(line).contains("refused", "does not accept"));
  }

  @Test
  void announce_withAnEffect_isRenewedAboutEveryQuarterOfASecond() {
    kit.with("EFFECT", "wrench 1 0 0 0 0 0").start(Thruster::new);
    kit.forget();

    kit.advance(2.0);

    assertThat(kit.published(Channels.ACTUATORS)).hasSizeBetween(7, 8);
    assertThat(announced().renewal()).hasValue(0.25);
  }

  @Test
  void derate_thenKill_isAnnouncedAtOnce() {
    Thruster thruster = start();
    thruster.derate(60.0);
    assertThat(announced().available()).hasValue(60.0);

    thruster.kill();
    kit.settle();

    assertThat(announced().available()).hasValue(0.0);
  }
}
